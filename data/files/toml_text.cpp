#include "data/files/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace pendular {
namespace {

constexpr int deepest_key = 16;  ///< largest number of parts of a dotted key or of a table's name

/// Index of the byte after the string that begins at `begin`, on one line or in triple quotes.
std::size_t after_string(const std::string& text, std::size_t begin) {
    const std::string quote(text.compare(begin, 3, std::string(3, text[begin])) == 0 ? 3 : 1,
                            text[begin]);
    std::size_t at = begin + quote.size();
    while (at < text.size() && text.compare(at, quote.size(), quote) != 0) {
        if (quote.size() == 1 && text[at] == '\n') return at;  // an error, which the parser reports
        at += quote[0] == '"' && text[at] == '\\' ? 2 : 1;
    }
    return std::min(at + quote.size(), text.size());
}

/// Checks that no key has so many parts (a.b.c has three) that the parser, which is recursive in
/// the parts, overflows the stack.
/// @throws InputError at the line of such a key
void refuse_deep_keys(const std::string& file, const std::string& text) {
    int line = 1, parts = 1;
    bool after_dot = false;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        const bool word = c == '"' || c == '\'' || c == '_' || c == '-' ||
                          std::isalnum(static_cast<unsigned char>(c)) || (c & 0x80) != 0;
        if (c == '.') {
            after_dot = true;
        } else if (word) {
            parts = after_dot ? parts + 1 : 1;
            after_dot = false;
        } else if (c != ' ' && c != '\t') {
            parts = 1, after_dot = false;
        }
        if (parts > deepest_key)
            throw InputError({file, line},
                             fmt::format("a name of more than {} parts joined by '.'; no key of "
                                         "this file has so many, so correct or remove it",
                                         deepest_key));
        std::size_t next = at + 1;
        if (c == '"' || c == '\'') {
            next = after_string(text, at);
        } else if (word) {
            while (next < text.size() && (std::isalnum(static_cast<unsigned char>(text[next])) ||
                                          text[next] == '_' || text[next] == '-'))
                ++next;
        }
        line +=
            static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                        text.begin() + static_cast<std::ptrdiff_t>(next), '\n'));
        at = next;
    }
}

}  // namespace

Position position_in(const std::string& file, const toml::source_position& where) {
    return {file, static_cast<int>(where.line), static_cast<int>(where.column)};
}

toml::table parse_toml(const std::string& file, const std::string& text) {
    refuse_deep_keys(file, text);
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(position_in(file, error.source().begin),
                         fmt::format("{}; correct the syntax here", error.description()));
    }
}

}  // namespace pendular
