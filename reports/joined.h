#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pendular {

/// Returns a list for a sentence: "a, b and c" if `last` is "and".
inline std::string joined(const std::vector<std::string>& words, const std::string& last) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == words.size() ? " " + last + " " : ", ") + words[k];
    }
    return text;
}

}  // namespace pendular
