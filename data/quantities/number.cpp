#include "data/quantities/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace pendular {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<double> take_number(std::string_view& text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<double> parse_number(std::string_view text) {
    text = trimmed(text);
    const auto value = take_number(text);
    return text.empty() ? value : std::nullopt;
}

std::optional<std::string> beyond_measure(double number) {
    if (!std::isfinite(number)) return "must be finite";
    if (std::abs(number) <= largest_magnitude) return std::nullopt;
    return fmt::format(
        "is {:.3g} in SI units, larger than any possible measurement ({:g}); correct it", number,
        largest_magnitude);
}

bool has_decimal_comma(std::string_view text) {
    if (std::count(text.begin(), text.end(), ',') != 1) return false;
    std::string with_point(text);
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    return parse_number(with_point).has_value();
}

bool is_number(std::string_view text) {
    return parse_number(text) || has_decimal_comma(text);
}

std::string short_text(double number) {
    const double size = std::abs(number);
    if (!(size >= 999.5 && size < 1e6)) return fmt::format("{:.3g}", number);
    const double unit = std::pow(10.0, std::floor(std::log10(size)) - 2);
    return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

std::string nominal_text(double mean) {
    if (mean == 0) return "0";
    // Controllers hold a set point to 1 or 2 %, and means over steps and replicates
    // are within a few tenths of a per cent.
    constexpr double near = 0.005;
    for (const int digits : {1, 2}) {
        const double unit = std::pow(10.0, std::floor(std::log10(std::abs(mean))) - (digits - 1));
        const double rounded = std::round(mean / unit) * unit;
        if (std::abs(rounded - mean) <= near * std::abs(mean)) return short_text(rounded);
    }
    return short_text(mean);
}

}  // namespace pendular
