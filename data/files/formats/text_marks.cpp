#include "data/files/formats/text_marks.h"

#include <algorithm>
#include <cctype>
#include <string_view>

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

void unify_signs(std::string& text) {
    constexpr std::string_view minus = "\u2212";
    const auto digit = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
    };
    if (text.find(minus) != std::string::npos) {
        std::string result;
        std::size_t from = 0;
        for (std::size_t at = text.find(minus); at != std::string::npos;
             at = text.find(minus, at + 1)) {
            const bool in_word = at > 0 && std::isalpha(static_cast<unsigned char>(text[at - 1])) &&
                                 text[at - 1] != 'E' && text[at - 1] != 'e';
            const std::size_t next = at + minus.size();
            if (in_word || !(digit(next) || text.compare(next, 1, ".") == 0)) continue;
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

}  // namespace pendular
