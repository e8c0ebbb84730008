#include "reports/with_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

struct Prefix {
    double factor;
    const char* letter;
};

/// SI prefix for a value of this size and unit; no prefix for angles, ratios and rates.
Prefix prefix_of(double size, const std::string& unit) {
    const bool scaled = unit == "N m" || unit == "N" || unit == "m" || unit == "N/m" ||
                        unit == "Pa" || unit == "Pa s";
    if (!scaled || !(size > 0)) {
        return {1, ""};
    }
    for (const Prefix& each : {Prefix{1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "u"}}) {
        if (size >= each.factor) {
            return each;
        }
    }
    return {1e-9, "n"};
}

}  // namespace

std::string with_error(double value, double error) {
    if (!(error > 0) || !std::isfinite(error)) {
        return fmt::format("{:.4g} +- {}", value, error);
    }
    const int power = static_cast<int>(std::floor(std::log10(error)));
    const int digits = std::max(0, 1 - power);
    if (digits > 7) {  // such as forces between grains [N]
        const int exponent = std::max(
            power, static_cast<int>(std::floor(std::log10(std::max(std::abs(value), error)))));
        const double unit = std::pow(10.0, exponent);
        return fmt::format("({:.{}f} +- {:.{}f})e{}", value / unit, exponent + digits, error / unit,
                           exponent + digits, exponent);
    }
    return fmt::format("{:.{}f} +- {:.{}f}", value, digits, error, digits);
}

std::string with_error(double value, double error, const std::string& unit) {
    const Prefix prefix = prefix_of(std::max(std::abs(value), std::abs(error)), unit);
    const std::string number = with_error(value / prefix.factor, error / prefix.factor);
    return unit == "1" ? number : fmt::format("{} {}{}", number, prefix.letter, unit);
}

std::string change_text(double change, double value, double error, const std::string& unit) {
    const Prefix prefix = prefix_of(std::max(std::abs(value), std::abs(error)), unit);
    const double rounded = error / prefix.factor;
    const int digits = rounded > 0 && std::isfinite(rounded)
                           ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(rounded))))
                           : 4;
    const std::string number = fmt::format("{:+.{}f}", change / prefix.factor, digits);
    return unit == "1" ? number : fmt::format("{} {}{}", number, prefix.letter, unit);
}

std::string with_unit(double value, const std::string& unit, int digits) {
    const Prefix prefix = prefix_of(std::abs(value), unit);
    const double scaled = value / prefix.factor;
    const std::string number = std::abs(scaled) < 100 || digits > 2
                                   ? fmt::format("{:.{}g}", scaled, digits)
                                   : fmt::format("{:.0f}", 10 * std::round(scaled / 10));
    return unit == "1" ? number : fmt::format("{} {}{}", number, prefix.letter, unit);
}

}  // namespace pendular
