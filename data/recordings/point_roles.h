#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Whether two loads are equal, or one is lower, by more than 5 %: loads that are set differ by
/// more.
bool is_same_load(double a, double b);
bool is_lower_load(double lower, double load);

/// Whether a text is a yes or a no, in one of the five languages.
bool is_answer(const std::string& text);

/// Whether a text begins with a word for a preshear or a consolidation, such as "Preshear?".
bool names_preshear(std::string_view text);

/// Returns the roles that a column of a table of points states, one for each row: "preshear",
/// "other" for steady shear after a point of failure at its load, or "" for a point of failure;
/// empty if the column states none.
///
/// Names of preshears, as "Preshear 1" and "consolidation", and "yes" or "1" in a column of such a
/// name, are preshears wherever they stand. So are "P", "pre" and "steady state" if each such row
/// is followed by rows of lower loads; other rows in "steady state", beside peaks, are "other".
/// @param loads of the rows, in one unit; empty: not known
std::vector<std::string> roles_in_column(std::string_view name,
                                         const std::vector<std::string>& cells,
                                         const std::vector<double>& loads);

/// Whether each row of a table of points has a stress that stands for a missing value rather than
/// for a test: one of nines alone far off all others (`marks_of_nines`), whose stress ratio is not
/// that of the other rows. Points of tension, and of shear in the other sense, are points. All
/// false for a file that is no table of points.
std::vector<bool> impossible_points(const BlockFile& file,
                                    const std::vector<IntervalSeries>& series);

}  // namespace pendular
