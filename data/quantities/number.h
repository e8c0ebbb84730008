#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pendular {

/// Text without blanks at either end.
std::string_view trimmed(std::string_view text);

/// Finite number that the whole text spells, blanks around it aside; empty if the text is no finite
/// number. The decimal sign is '.' in every locale.
std::optional<double> parse_number(std::string_view text);

/// Largest magnitude in SI units of a quantity that a study may state. Values beyond it are
/// mistakes, and their powers overflow in a fit.
constexpr double largest_magnitude = 1e15;
/// Smallest magnitude in SI units of a quantity that must not be 0, a standard deviation for
/// example.
constexpr double smallest_magnitude = 1e-15;

/// Reason why a number in SI units cannot be a measured value: it is not finite, or its magnitude
/// exceeds `largest_magnitude`. Empty if it can be a measured value.
std::optional<std::string> beyond_measure(double number);

/// Text of a number with three significant digits; an exponent is used only below 0.0001 and from a
/// million on: "1000", "0.0123", "2e+07".
std::string short_text(double number);

/// Whether the text is a number with a decimal comma, such as "1,25".
bool has_decimal_comma(std::string_view text);

}  // namespace pendular
