#pragma once

#include <string_view>
#include <vector>

namespace pendular {

/// Numbers of digits with which the numbers in a column of a table are written.
struct Digits {
    /// Maximum number of significant digits among the numbers of the column, trailing zeros not
    /// counted.
    int significant = 0;
    /// Maximum number of digits after the decimal point among the numbers of the column, trailing
    /// zeros not counted.
    int decimals = 0;
};

/// Returns the maximum numbers of significant digits and of decimals among the numbers in a column.
/// Cells without digits are ignored.
/// @param cells texts of the column's cells
Digits digits_of(const std::vector<std::string_view>& cells);

/// Returns the step to which a value was rounded, in the unit of the value's column: the place
/// value of the last decimal or of the last significant digit, whichever is larger. The result is 0
/// for a value of 0 and for a column without digits. Rounding to the step causes an error with the
/// variance step^2/12.
double resolution_of(double value, const Digits& digits);

}  // namespace pendular
