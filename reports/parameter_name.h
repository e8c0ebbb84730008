#pragma once

#include <string>

namespace pendular {

/// Returns a parameter's name in a sentence: "intergranular friction coefficient" for `friction`,
/// otherwise the name itself.
inline std::string parameter_in_words(const std::string& parameter) {
    return parameter == "friction" ? "intergranular friction coefficient" : parameter;
}

}  // namespace pendular
