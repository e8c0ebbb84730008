#include "data/files/resolution.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace pendular {
namespace {

Digits digits_of(std::string_view cell) {
    Digits result;
    int digits = 0, since_point = 0;
    bool started = false, point = false;
    for (const char c : cell) {
        if (c == 'e' || c == 'E') break;
        if (c == '.' || c == ',') {
            point = true;
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            started |= c != '0';
            digits += started;
            since_point += point;
            if (c != '0') {
                result.significant = digits;
                result.decimals = since_point;
            }
        }
    }
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
