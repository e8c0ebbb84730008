#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "data/files/csv.h"

namespace pendular {

/// Whether all words of a text are those of a mean, a scatter or the like: "Mean (n=4)", "Std.
/// dev.", "Mittelwert". Names with further words, "Mean flow" or "Max-1", are those of samples.
bool names_statistic(std::string_view text);

/// Returns the indices of the rows that state statistics or results of a table in place of values:
/// - the last rows, of a label that no other row has: one of the words above or, in any language,
///   of numbers that are means, standard deviations (of n or n - 1 values), their ratio, standard
///   errors, variances or sums of the columns above to the digits that are written; without a
///   label, of such numbers with more decimals than all above;
/// - results of a line among the last rows ("pente;0,53"), and a table of them below its names;
/// - rows with a word above anywhere that state such numbers of the rows since the last of them.
/// @param rows all rows below the names, in order
std::vector<std::size_t> rows_of_statistics(const std::vector<Row>& rows);

}  // namespace pendular
