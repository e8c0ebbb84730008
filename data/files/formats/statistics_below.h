#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "data/files/csv.h"

namespace pendular {

/// Whether all words of a text are those of a mean, a scatter or the like: "Mean (n=4)", "Std.
/// dev.", "Mittelwert". Names with further words, "Mean flow" or "Max-1", are those of samples.
bool names_statistic(std::string_view text);

/// Returns how many rows of a table are rows; the last ones, if fewer, state statistics of their
/// columns. Such a row has a label that no other row has: one of the words above or, in any
/// language, of numbers that are means, standard deviations (of n or n - 1 values), their ratio,
/// standard errors, variances or sums of the columns above to the digits that are written.
/// @param rows all rows below the names, in order
std::size_t rows_above_statistics(const std::vector<Row>& rows);

}  // namespace pendular
