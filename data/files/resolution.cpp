#include "data/files/resolution.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace pendular {
namespace {

/// Exponent of ten behind the 'e' of a number; 0 where there is none.
int exponent_of(std::string_view number) {
    const std::size_t e = number.find_first_of("eE");
    if (e == std::string_view::npos) return 0;
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    int exponent = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    return exponent;
}

Digits digits_of(std::string_view cell) {
    Digits result;
    bool started = false, point = false;
    for (const char c : cell.substr(0, cell.find_first_of("eE"))) {
        if (c == '.' || c == ',') {
            point = true;
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            started |= c != '0';
            result.significant += started;
            result.decimals += point;
        }
    }
    result.decimals = std::max(0, result.decimals - exponent_of(cell));
    return result;
}

}  // namespace

Digits digits_of(const std::vector<std::string_view>& cells) {
    Digits most;
    for (const std::string_view cell : cells) {
        const Digits own = digits_of(cell);
        most.significant = std::max(most.significant, own.significant);
        most.decimals = std::max(most.decimals, own.decimals);
    }
    return most;
}

double resolution_of(double value, const Digits& digits) {
    if (value == 0 || digits.significant == 0) return 0;
    const double by_digit =
        std::pow(10, std::floor(std::log10(std::abs(value))) - digits.significant + 1);
    return std::max(by_digit, std::pow(10.0, -digits.decimals));
}

}  // namespace pendular
