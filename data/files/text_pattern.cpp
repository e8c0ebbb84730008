#include "data/files/text_pattern.h"

#include <regex>

namespace pendular {
namespace {

PatternMatch as_pattern_match(const std::cmatch& found, const char* text) {
    PatternMatch match{static_cast<std::size_t>(found[0].first - text),
                       static_cast<std::size_t>(found[0].second - text),
                       {}};
    match.parts.assign(found.begin(), found.end());
    return match;
}

}  // namespace

struct TextPattern::Compiled {
    std::regex expression;
};

TextPattern::TextPattern(const std::string& expression)
    : compiled_(std::make_shared<const Compiled>(Compiled{std::regex(expression)})) {}

std::optional<PatternMatch> TextPattern::whole(std::string_view text) const {
    std::cmatch found;
    const char* const begin = text.data();
    if (!std::regex_match(begin, begin + text.size(), found, compiled_->expression))
        return std::nullopt;
    return as_pattern_match(found, begin);
}

std::optional<PatternMatch> TextPattern::first(std::string_view text) const {
    std::cmatch found;
    const char* const begin = text.data();
    if (!std::regex_search(begin, begin + text.size(), found, compiled_->expression))
        return std::nullopt;
    return as_pattern_match(found, begin);
}

std::vector<PatternMatch> TextPattern::all(std::string_view text) const {
    std::vector<PatternMatch> matches;
    const char* const begin = text.data();
    for (std::cregex_iterator each(begin, begin + text.size(), compiled_->expression), end;
         each != end; ++each) {
        matches.push_back(as_pattern_match(*each, begin));
    }
    return matches;
}

}  // namespace pendular
