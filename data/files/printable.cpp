#include "data/files/printable.h"

#include <fmt/format.h>
#include <unicode/utf8.h>

#include <cstdint>

namespace pendular {
namespace {

bool is_harmless(UChar32 c) {
    if (c == '\n' || c == '\t') return true;
    const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
    const bool direction = c == 0x61c || c == 0x200e || c == 0x200f ||
                           (c >= 0x2028 && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
    return !control && !direction;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    const auto length = static_cast<std::int32_t>(text.size());
    for (std::int32_t at = 0; at < length;) {
        const std::int32_t begin = at;
        UChar32 c = 0;
        U8_NEXT(text.data(), at, length, c);
        if (c >= 0 && is_harmless(c)) {
            result +=
                text.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(at - begin));
        } else if (c > 0xff) {
            result += fmt::format("\\u{:04x}", c);
        } else {
            for (std::int32_t k = begin; k < at; ++k)
                result += fmt::format(
                    "\\x{:02x}", static_cast<unsigned char>(text[static_cast<std::size_t>(k)]));
        }
    }
    return result;
}

}  // namespace pendular
