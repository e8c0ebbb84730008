#pragma once

#include <string>

namespace pendular {

/// Returns the name of a fitted parameter for use in a sentence: "intergranular friction
/// coefficient" for `friction`, the unchanged name for any other parameter.
inline std::string parameter_in_words(const std::string& parameter) {
    return parameter == "friction" ? "intergranular friction coefficient" : parameter;
}

}  // namespace pendular
