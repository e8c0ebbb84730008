#include "reports/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace pendular {
namespace {

/// Escaped backslash. The empty group keeps gnuplot from reading a user's "\U+00e9" as a character
/// code.
constexpr std::string_view escaped_backslash = "\\\\{}";

bool is_control(char c) {
    return (c >= 0 && c < ' ') || c == '\x7f';
}

bool begins_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

/// Pieces of a text between the places where a line may break: after hyphens and line ends, and
/// after every 24 characters without such a place.
std::vector<std::string> pieces_of(const std::string& text) {
    constexpr std::size_t longest = 24;
    std::vector<std::string> pieces = {""};
    for (const char c : text) {
        std::string& last = pieces.back();
        const bool ended = !last.empty() && (last.back() == '-' || last.back() == '\n');
        if (ended || (begins_character(c) && characters(last) == longest)) {
            pieces.emplace_back();
        }
        pieces.back() += c;
    }
    return pieces;
}

}  // namespace

std::string plain_text(const std::string& text) {
    constexpr std::string_view markup = "_^{}@&~";
    std::string result;
    for (const char c : text) {
        if (c == '\\') {
            result += escaped_backslash;
        } else {
            result += markup.find(c) == std::string_view::npos ? "" : "\\";
            result += is_control(c) ? ' ' : c;
        }
    }
    return result;
}

std::string unescaped(const std::string& text) {
    std::string result;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool backslash = text.compare(k, escaped_backslash.size(), escaped_backslash) == 0;
        const std::size_t to_last = backslash ? escaped_backslash.size() - 1 : 0;
        k += !backslash && text[k] == '\\' && k + 1 < text.size();
        result += text[k];
        k += to_last;
    }
    return result;
}

std::vector<std::string> broken_name(const std::string& name) {
    constexpr std::size_t longest = 10;  // characters of a line, as wide as a bar with its gap
    std::vector<std::string> lines = {""};
    for (const std::string& piece : pieces_of(name)) {
        const std::string& last = lines.back();
        const bool full = characters(last) + characters(piece) > longest;
        if (!last.empty() && (full || last.back() == '\n')) {
            lines.emplace_back();
        }
        lines.back() += piece;
    }
    std::ranges::transform(lines, lines.begin(), plain_text);
    return lines;
}

std::string gnuplot_string(const std::string& text) {
    // Digits have codes too: behind an octal code gnuplot would read them as part of it.
    const auto is_safe = [](char c) {
        return c == ' ' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               static_cast<unsigned char>(c) >= 0x80;
    };
    std::string result = "\"";
    for (const char c : text) {
        result += is_safe(c) ? std::string{c} : fmt::format("\\{:03o}", static_cast<int>(c));
    }
    return result + '"';
}

}  // namespace pendular
