#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pendular {

/// Returns a text without the blanks, tabs and line ends at the beginning and end of the text.
std::string_view trimmed(std::string_view text);

/// Converts a text to a finite number. The result is empty if the text is not a finite number. The
/// decimal mark is '.' in every locale. Blanks before and after the number are allowed.
std::optional<double> parse_number(std::string_view text);

/// Largest magnitude, in SI units, that is accepted for a measured quantity. Larger magnitudes are
/// refused as mistakes, since powers of larger magnitudes would overflow in a fit.
constexpr double largest_magnitude = 1e15;
/// Smallest magnitude, in SI units, that is accepted for a quantity that must not be 0, such as a
/// standard deviation.
constexpr double smallest_magnitude = 1e-15;

/// Returns the reason why a number in SI units cannot be a measured value, as the end of an error
/// message: the number is not finite, or its magnitude exceeds `largest_magnitude`. The result is
/// empty if the number can be a measured value.
std::optional<std::string> beyond_measure(double number);

/// Returns a number as text with three significant digits, such as "1000", "0.0123" or "2e+07".
/// Numbers of magnitude below 0.0001, and of a million or more, are written with an exponent.
std::string short_text(double number);

/// Returns the set point that a mean of recorded values stands for, as text: the number with the
/// fewest digits within 0.5 % of `mean`, at most three digits ("200" for 199.9, "0.01" for
/// 0.00999).
std::string nominal_text(double mean);

/// Whether a text is a number with a decimal comma, such as "1,25".
bool has_decimal_comma(std::string_view text);

}  // namespace pendular
