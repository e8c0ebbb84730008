#pragma once

#include <string_view>
#include <vector>

namespace pendular {

/// Largest numbers of significant digits and of decimals among the numbers in a column of a table.
struct Digits {
    int significant = 0;  ///< most significant digits, trailing zeros aside
    int decimals = 0;     ///< most digits after the decimal point, trailing zeros aside
};

/// Largest numbers of significant digits and of decimals among the numbers in a column, from the
/// texts of its cells. Cells without digits are ignored.
Digits digits_of(const std::vector<std::string_view>& cells);

/// Step to which a value was rounded in a column with these digits, in the column's unit: the
/// coarser of the last decimal and the last significant digit. Returns 0 for a value of 0 and for a
/// column without digits. Rounding to this step makes an error of variance step^2/12.
double resolution_of(double value, const Digits& digits);

}  // namespace pendular
