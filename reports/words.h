#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "workflow/listener.h"

namespace pendular {

/// Returns a text as a sentence. The first letter becomes a capital if the first word consists of
/// lower-case letters only. A full stop is added unless the text ends in ".", "?", a line end, or a
/// command after ": pendular ".
std::string as_sentence(std::string text);

/// Returns a duration for messages: "40 s", "1 min 20 s", "3 h 5 min".
std::string duration(double seconds);

/// Returns a sentence on the progress that `event` reports: the stage that begins, the share of
/// simulations done, the friction coefficient at the end of a round, or the number of refits to do.
/// Empty for a note or a single refit.
std::string progress_sentence(const Event& event);

/// Returns the finished share of simulations or refits [1], if `event` reports one.
std::optional<double> progress_share(const Event& event);

/// Returns a text such as "45 %, 1 of 3 simulations done, 20 s left".
std::string progress_numbers(const EnsembleProgress& progress);

/// Returns a name with spaces in place of underscores: "inertial number".
std::string spoken(std::string name);

/// Returns a list for a sentence: "a, b and c" if `last` is "and".
inline std::string joined(const std::vector<std::string>& words, const std::string& last) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == words.size() ? " " + last + " " : ", ") + words[k];
    }
    return text;
}

/// Returns a parameter's name in a sentence: "intergranular friction coefficient" for `friction`,
/// otherwise the name itself.
inline std::string parameter_in_words(const std::string& parameter) {
    return parameter == "friction" ? "intergranular friction coefficient" : parameter;
}

}  // namespace pendular
