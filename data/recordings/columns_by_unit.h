#pragma once

#include <map>
#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Whether the name of a column is that of something else than a quantity of its unit: of a
/// displacement, not a height, or of a residual stress.
bool names_another(std::string_view name, std::string_view quantity);

/// Returns columns of a table of someone's own that are read as a quantity by their unit alone: a
/// quantity of steady shear is missing, and no other column has a unit that fits it. A column of
/// clock times is one of times. Set points, columns of errors and of other kinds of tests are none,
/// nor are those whose names say something else: displacements are no height, and forces no
/// lever's. Tables of points of failure have none.
/// @return as `FileFormat::named_columns`: text of the column, by quantity
std::map<std::string, std::string> columns_by_unit(const BlockFile& file);

/// Returns columns that may number the intervals although their name does not say so, with the
/// quantity "interval": whole numbers without a unit that change where, and only where, the speed
/// of the lid or the load on it does. Only for tables of someone's own that hold one interval.
/// @param series in the order of the file's blocks
std::vector<BlockColumn> columns_like_intervals(const BlockFile& file,
                                                const std::vector<IntervalSeries>& series);

}  // namespace pendular
