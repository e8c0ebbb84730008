#pragma once

#include <string_view>
#include <vector>

namespace pendular {

/// Resolution of a column of numbers, as digits.
struct Digits {
    int significant = 0;  ///< most significant digits of any number, zeros at its end not counted
    int decimals = 0;     ///< most digits after the decimal point of any number
};

/// The digits of a column's cells, as they were written. Cells that are no numbers count for
/// nothing.
Digits digits_of(const std::vector<std::string_view>& cells);

/// Step between neighbouring numbers of a given size in a column with these digits, in its unit:
/// the coarser of the last decimal and the last significant digit. Rounding to it makes an error of
/// up to half a step, of variance step^2/12.
double resolution_of(double value, const Digits& digits);

}  // namespace pendular
