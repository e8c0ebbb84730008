#pragma once

#include <string_view>
#include <vector>

namespace pendular {

/// Largest numbers of digits among the numbers in a column of a table. Trailing zeros count: who
/// writes 300.0 knows the value to 0.1. Exponents do not.
struct Digits {
    int significant = 0;
    int decimals = 0;  ///< digits after the decimal mark
};

/// Returns the digits of a column's cells. Cells without digits are ignored.
Digits digits_of(const std::vector<std::string_view>& cells);

/// Returns the step to which a value was rounded, in the unit of its column: the place value of the
/// last decimal or of the last significant digit, whichever is larger; 0 for a value of 0 and for a
/// column without digits. Rounding to the step causes an error with the variance step^2/12.
double resolution_of(double value, const Digits& digits);

}  // namespace pendular
