#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace pendular {

/// Returns a whole number of so many bytes, the lowest first; bytes beyond the end count as 0.
inline std::uint64_t whole_number(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;)
        value =
            value << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0);
    return value;
}

inline unsigned one_byte(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

inline std::uint16_t two_bytes(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint16_t>(whole_number(bytes, at, 2));
}

inline std::uint32_t four_bytes(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint32_t>(whole_number(bytes, at, 4));
}

/// Number of double precision, as IEEE 754 has it.
inline double double_of(std::uint64_t bits) {
    return std::bit_cast<double>(bits);
}

}  // namespace pendular
