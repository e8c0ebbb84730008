#include "data/files/formats/text_marks.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Byte after the quote that closes the cell whose first byte, behind its opening quote, is `at`;
/// npos where none within a few lines does.
std::size_t end_of_quoted(const std::string& text, std::size_t at) {
    constexpr std::size_t longest = 2000;
    const std::size_t last = std::min(text.size(), at + longest);
    for (std::size_t i = at; i < last; ++i) {
        if (text[i] != '"') continue;
        if (i + 1 < text.size() && text[i + 1] == '"') {
            ++i;
            continue;
        }
        const bool closes =
            i + 1 == text.size() ||
            std::string_view("\t;,\r\n ").find(text[i + 1]) != std::string_view::npos;
        return closes ? i + 1 : std::string::npos;
    }
    return std::string::npos;
}

}  // namespace

void join_quoted_lines(std::string& text) {
    constexpr int most_lines = 200;  // as those among which the names are sought
    std::size_t length = 0;
    for (int lines = 0; length < text.size() && lines < most_lines; ++lines)
        length = std::min(text.find_first_of("\r\n", length), text.size() - 1) + 1;
    std::string owed;  // line ends that follow the present line
    for (std::size_t i = 0; i < std::min(length, text.size()); ++i) {
        if (text[i] == '\n' || text[i] == '\r') {
            if (text.compare(i, 2, "\r\n") == 0) ++i;
            text.insert(i + 1, owed);
            i += owed.size();
            length += owed.size();
            owed.clear();
            continue;
        }
        const bool begins =
            i == 0 || (i == 3 && text.starts_with("\xEF\xBB\xBF")) ||
            std::string_view("\t;,\r\n").find(text[i - 1]) != std::string_view::npos;
        if (text[i] != '"' || !begins) continue;
        const std::size_t end = end_of_quoted(text, i + 1);
        if (end == std::string::npos) return;
        for (std::size_t k = i; k < end; ++k) {
            if (text[k] == '\n') owed += '\n';
            if (text[k] == '\r' && text[k + 1] != '\n') owed += '\r';
            if (text[k] == '\n' || text[k] == '\r') text[k] = ' ';
        }
        i = end - 1;
    }
}

namespace {

/// Replaces each of the signs between others than digits by blanks, as many as it has bytes.
/// Between digits, they may divide thousands.
void blank_out(std::string& text, std::string_view sign) {
    const auto digit = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
    };
    for (std::size_t at = text.find(sign); at != std::string::npos;
         at = text.find(sign, at + sign.size()))
        if (!(at > 0 && digit(at - 1) && digit(at + sign.size())))
            text.replace(at, sign.size(), sign.size(), ' ');
}

/// Lets "µ", "°" and "²" be themselves where a program took their bytes in UTF-8 for two characters
/// of another encoding, as in "ÂµNm".
void repair_signs(std::string& text) {
    constexpr std::string_view twice = "\u00c2\u00b5";  // and others that begin alike
    const std::string_view begin = twice.substr(0, 3);
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
        if (at + 3 < text.size() &&
            std::string_view("\xB5\xB0\xB2\xB3\xB7").find(text[at + 3]) != std::string_view::npos)
            text.erase(at, 2);
}

}  // namespace

void unify_signs(std::string& text) {
    for (const std::string_view blank : {"\u00a0", "\u202f"})
        blank_out(text, blank);
    repair_signs(text);
    const auto digit = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
    };
    // A dash, which texts of figures have for a minus, divides a range behind a digit.
    for (const std::string_view minus : {"\u2212", "\u2013"}) {
        if (text.find(minus) == std::string::npos) continue;
        const bool dash = minus == "\u2013";
        std::string result;
        std::size_t from = 0;
        for (std::size_t at = text.find(minus); at != std::string::npos;
             at = text.find(minus, at + 1)) {
            const bool in_word = at > 0 && std::isalpha(static_cast<unsigned char>(text[at - 1])) &&
                                 text[at - 1] != 'E' && text[at - 1] != 'e';
            const std::size_t next = at + minus.size();
            if (in_word || (dash && at > 0 && digit(at - 1)) ||
                !(digit(next) || text.compare(next, 1, ".") == 0))
                continue;
            result.append(text, from, at - from).append("-");
            from = next;
        }
        text = result.append(text, from);
    }
    for (const char exponent : {'D', 'd'})
        for (std::size_t at = text.find(exponent); at != std::string::npos;
             at = text.find(exponent, at + 1)) {
            const bool has_sign =
                text.compare(at + 1, 1, "-") == 0 || text.compare(at + 1, 1, "+") == 0;
            if (!has_sign || !digit(at + 2)) continue;
            std::size_t begin = at;
            while (begin > 0 && digit(begin - 1))
                --begin;
            // Only behind a decimal point: "3D-2" is a name.
            if (begin > 0 && text[begin - 1] == '.') text[at] = 'E';
        }
}

namespace {

/// Number of the cells with a text in a line with tabs between them, and of its tabs.
struct TabbedLine {
    std::size_t filled = 0, tabs = 0;
};

TabbedLine tabbed(std::string_view line) {
    TabbedLine found;
    bool in_cell = false;
    for (const char c : line) {
        found.tabs += c == '\t';
        const bool fills = c != '\t' && (in_cell || c != ' ');
        found.filled += fills && !in_cell;
        in_cell = fills;
    }
    return found;
}

}  // namespace

void join_tabs(std::string& text) {
    if (text.find("\t\t") == std::string::npos) return;
    TabbedLine first;
    bool aligned = false;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        begin = end + 1;
        if (trimmed(line).empty()) continue;
        const TabbedLine here = tabbed(line);
        if (first.filled == 0) first = here;
        if (here.filled != first.filled || here.filled < 2 || line.starts_with('\t')) return;
        aligned = aligned || here.tabs != first.tabs;
    }
    if (!aligned) return;
    for (std::size_t i = 0; i + 1 < text.size(); ++i)
        if (text[i] == '\t' && text[i + 1] == '\t') text[i] = ' ';
}

}  // namespace pendular
