#include "data/files/header_cell.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Index of the bracket that opens the pair which the last character of a text closes; npos if the
/// text does not end with such a pair.
std::size_t opening_bracket(std::string_view text) {
    if (text.empty() || (text.back() != ']' && text.back() != ')')) return std::string_view::npos;
    int depth = 0;
    for (std::size_t i = text.size(); i-- > 0;) {
        if (text[i] == ']' || text[i] == ')') ++depth;
        if (text[i] == '[' || text[i] == '(') --depth;
        if (depth == 0) return i;
    }
    return std::string_view::npos;
}

struct Spelling {
    std::string_view text;
    ErrorMark mark;
};
constexpr std::array spellings = {Spelling{"standard deviation", ErrorMark::standard_deviation},
                                  Spelling{"standard error", ErrorMark::standard_error},
                                  Spelling{"uncertainty", ErrorMark::standard_error},
                                  Spelling{"stddev", ErrorMark::standard_deviation},
                                  Spelling{"stdev", ErrorMark::standard_deviation},
                                  Spelling{"stderr", ErrorMark::standard_error},
                                  Spelling{"error", ErrorMark::standard_error},
                                  Spelling{"std", ErrorMark::standard_deviation},
                                  Spelling{"u95", ErrorMark::half_width},
                                  Spelling{"sd", ErrorMark::standard_deviation},
                                  Spelling{"se", ErrorMark::standard_error}};

/// Takes a mark of errors such as "_sd" off the end of a name, with its separator.
ErrorMark take_mark(std::string_view& name) {
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& [text, mark] : spellings) {
        if (!lower.ends_with(text) || lower.size() <= text.size()) continue;
        const char separator = lower[lower.size() - text.size() - 1];
        if (separator != '_' && separator != ' ') continue;
        name.remove_suffix(text.size() + 1);
        return mark;
    }
    return ErrorMark::none;
}

}  // namespace

HeaderCell parse_header_cell(std::string_view text) {
    text = trimmed(text);
    HeaderCell cell;
    std::string_view name = text;
    if (const std::size_t bracket = opening_bracket(text); bracket != std::string_view::npos) {
        name = text.substr(0, bracket);
        cell.unit = trimmed(text.substr(bracket + 1, text.size() - bracket - 2));
    } else if (const std::size_t in = text.rfind(" in "); in != std::string_view::npos) {
        name = text.substr(0, in);
        cell.unit = trimmed(text.substr(in + 4));
    }
    name = trimmed(name);
    cell.mark = take_mark(name);
    cell.name = trimmed(name);
    return cell;
}

}  // namespace pendular
