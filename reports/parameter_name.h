#pragma once

#include <string>

namespace pendular {

/// Returns the name of a fitted parameter as in a sentence: "friction coefficient" for `friction`,
/// the parameter's own name otherwise.
inline std::string parameter_in_words(const std::string& parameter) {
    return parameter == "friction" ? "friction coefficient" : parameter;
}

}  // namespace pendular
