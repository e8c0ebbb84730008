#include "reports/with_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace pendular {
namespace {

/// Unit for printing.
struct Scale {
    double factor;     ///< one such unit [SI unit]
    std::string unit;  ///< "mN m"
};

/// Unit for printing a value of this size: the SI unit with a prefix, degrees for angles, the SI
/// unit itself for ratios and rates.
Scale scale_of(double size, const std::string& unit) {
    if (unit == "rad") return {std::numbers::pi / 180, "deg"};
    // The prefix belongs to the first symbol, which must not have an exponent.
    const std::string first = unit.substr(0, unit.find_first_of(" /^"));
    const bool scaled = (first == "N" || first == "m" || first == "Pa") &&
                        !unit.substr(first.size()).starts_with('^');
    if (!scaled || !(size > 0)) return {1, unit};
    for (const auto& [factor, letter] :
         {std::pair{1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "u"}}) {
        if (size >= factor) return {factor, letter + unit};
    }
    return {1e-9, "n" + unit};
}

/// Text of a number with its unit; the unit "1" is left out.
std::string with_unit_name(const std::string& number, const std::string& unit) {
    return unit == "1" ? number : number + " " + unit;
}

}  // namespace

int decimals_for(double standard_error) {
    return std::max(0, 1 - static_cast<int>(std::floor(std::log10(standard_error))));
}

std::string with_error(double value, double error) {
    if (!(error > 0) || !std::isfinite(error)) {
        return fmt::format("{:.4g} +- {}", value, error);
    }
    const int power = static_cast<int>(std::floor(std::log10(error)));
    const int digits = decimals_for(error);
    if (digits > 7) {  // such as forces between grains [N]
        const int exponent = std::max(
            power, static_cast<int>(std::floor(std::log10(std::max(std::abs(value), error)))));
        const double unit = std::pow(10.0, exponent);
        return fmt::format("({:.{}f} +- {:.{}f})e{}", value / unit, exponent + digits, error / unit,
                           exponent + digits, exponent);
    }
    const double step = std::pow(10.0, power - 1);  // 10 and more have no decimals to leave out
    const auto rounded = [&](double x) { return step > 1 ? step * std::round(x / step) : x; };
    return fmt::format("{:.{}f} +- {:.{}f}", rounded(value), digits, rounded(error), digits);
}

std::string with_error(double value, double error, const std::string& unit) {
    const Scale scale = scale_of(std::max(std::abs(value), std::abs(error)), unit);
    const std::string number = with_error(value / scale.factor, error / scale.factor);
    return with_unit_name(number, scale.unit);
}

std::string estimate_text(double value, double error, const std::string& unit, double width,
                          bool at_bound) {
    constexpr int digits = 4;  // no error says how many are known
    const std::string plain = with_unit(value, unit, digits);
    if (error >= width || !std::isfinite(error)) return plain + ", not determined";
    if (!at_bound) return with_error(value, error, unit);
    return (error > 0 ? with_error(value, error, unit) : plain) + " (at bound)";
}

std::string estimate_text(const Fit& fit, Eigen::Index k, const std::string& unit) {
    const auto at = static_cast<std::size_t>(k);
    return estimate_text(fit.parameters(k), fit.standard_error(k), unit, fit.width(k),
                         at < fit.at_bound.size() && fit.at_bound[at]);
}

std::string change_text(double change, double value, double error, const std::string& unit) {
    const Scale scale = scale_of(std::max(std::abs(value), std::abs(error)), unit);
    const double scaled = error / scale.factor;
    const int digits = scaled > 0 && std::isfinite(scaled) ? decimals_for(scaled) : 4;
    std::string number = fmt::format("{:+.{}f}", change / scale.factor, digits);
    if (number.find_first_of("123456789") == std::string::npos) number.erase(0, 1);
    return with_unit_name(number, scale.unit);
}

std::string with_unit(double value, const std::string& unit, int digits) {
    const Scale scale = scale_of(std::abs(value), unit);
    const double scaled = value / scale.factor;
    const std::string number = std::abs(scaled) < 100 || digits > 2
                                   ? fmt::format("{:.{}g}", scaled, digits)
                                   : fmt::format("{:.0f}", 10 * std::round(scaled / 10));
    return with_unit_name(number, scale.unit);
}

}  // namespace pendular
