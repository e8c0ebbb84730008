#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pendular {

/// Text without blanks at either end.
std::string_view trimmed(std::string_view text);

/// Finite number that the whole text spells, decimal point '.', whatever the locale; else empty.
std::optional<double> parse_number(std::string_view text);

/// The number with three significant digits and, from 0.001 to a million, without an exponent:
/// "1000", "0.0123", "2e+07".
std::string short_text(double number);

/// Whether the text would be a number if its one ',' were a '.': "1,25".
bool has_decimal_comma(std::string_view text);

}  // namespace pendular
