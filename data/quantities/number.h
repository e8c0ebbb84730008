#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pendular {

/// Returns a text without blanks, tabs and line ends at its beginning and end.
std::string_view trimmed(std::string_view text);

/// Returns the finite number that a text states, with blanks around it allowed; empty for any other
/// text. The decimal mark is '.' in every locale.
std::optional<double> parse_number(std::string_view text);

/// Removes the finite number with which a text begins and returns it; empty, and the text may have
/// lost a plus sign, if no number begins there.
std::optional<double> take_number(std::string_view& text);

/// Largest magnitude [SI unit] that is accepted for a measured quantity: powers of larger
/// magnitudes would overflow in a fit.
constexpr double largest_magnitude = 1e15;
/// Smallest magnitude [SI unit] that is accepted for a quantity that must not be 0, such as a
/// standard deviation.
constexpr double smallest_magnitude = 1e-15;

/// Returns, as the end of an error message, why a number [SI unit] cannot be a measured value: it
/// is not finite or exceeds `largest_magnitude`. Empty if it can be.
std::optional<std::string> beyond_measure(double number);

/// Returns a number as text with three significant digits: "1000", "0.0123" or, below 0.0001 and
/// from a million on, "2e+07".
std::string short_text(double number);

/// Returns the set point that a mean of recorded values stands for: the number with the fewest
/// digits within 0.5 % of `mean`, at most three ("200" for 199.9, "0.01" for 0.00999).
std::string nominal_text(double mean);

/// Whether a text is a number with a decimal comma, such as "1,25".
bool has_decimal_comma(std::string_view text);

/// Whether a text is a finite number with either decimal mark.
bool is_number(std::string_view text);

}  // namespace pendular
