#include "data/files/header_cell.h"

#include <algorithm>
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

/// Length of a mark of standard deviations such as "_sd" at the end of a name, with its separator;
/// 0 if there is none.
std::size_t deviation_mark(std::string_view name) {
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const std::string_view mark : {"standard deviation", "standard error", "uncertainty",
                                        "stddev", "stdev", "stderr", "error", "std", "sd", "se"}) {
        if (!lower.ends_with(mark) || lower.size() <= mark.size()) continue;
        const char separator = lower[lower.size() - mark.size() - 1];
        if (separator == '_' || separator == ' ') return mark.size() + 1;
    }
    return 0;
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
    const std::size_t mark = deviation_mark(name);
    cell.deviation = mark > 0;
    cell.name = trimmed(name.substr(0, name.size() - mark));
    return cell;
}

}  // namespace pendular
