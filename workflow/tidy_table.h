#pragma once

#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// First characters of every table that `tidy_table` returns, by which the program recognises an
/// earlier table before a new one replaces it.
constexpr const char* tidy_table_begin = "test,interval,role,line";

/// Returns the data points of all intervals of a file of measurements as one CSV table in SI units.
/// The first row contains the names of the columns, the second their units: test, number and role
/// of the interval, line of the file, and every quantity that an interval contains. Cells without a
/// value are empty. Origin and pandas (header=[0, 1]) can read the table.
std::string tidy_table(const FileView& view);

}  // namespace pendular
