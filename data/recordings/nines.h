#pragma once

#include <cstddef>
#include <vector>

namespace pendular {

/// Whether a number is one of nines alone, as -999 or 9999.9, with which many programs mark that
/// there is no value. 99 and 99.9 are usual values.
bool is_of_nines(double value);

/// Returns the indices of the numbers of nines in a column that cannot be measured beside the
/// others: three times as large as any other value, or alone negative. Empty if more than half of
/// the values are such numbers.
/// @param values in the unit of the file
std::vector<std::size_t> marks_of_nines(const std::vector<double>& values);

}  // namespace pendular
