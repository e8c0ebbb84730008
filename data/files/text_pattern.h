#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Where a pattern is found in a text.
struct PatternMatch {
    std::size_t begin = 0, end = 0;  ///< bytes of the text
    /// Text of the match, then that of each pair of parentheses, "" for a pair that matched none.
    std::vector<std::string> parts;
};

/// Regular expression in the grammar of ECMAScript. The standard's <regex> is included in one file,
/// since each file that uses it takes two seconds longer to compile.
class TextPattern {
  public:
    explicit TextPattern(const std::string& expression);

    /// Match of a whole text.
    std::optional<PatternMatch> whole(std::string_view text) const;
    /// First match in a text.
    std::optional<PatternMatch> first(std::string_view text) const;
    /// All matches in a text, from left to right.
    std::vector<PatternMatch> all(std::string_view text) const;

  private:
    struct Compiled;
    std::shared_ptr<const Compiled> compiled_;
};

}  // namespace pendular
