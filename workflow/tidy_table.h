#pragma once

#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// First characters of every table that `tidy_table` returns. By these characters, the program
/// recognises an earlier table before a new table replaces it.
constexpr const char* tidy_table_begin = "test,interval,role,line";

/// Returns the data points of all intervals of a file of measurements as the text of one CSV table
/// in SI units. The first two rows contain the names and the units of the columns. Origin and
/// pandas (header=[0, 1]) read this form. Columns are test, interval, role, line of the file, and
/// every quantity that an interval contains. Cells without a value are empty.
std::string tidy_table(const FileView& view);

}  // namespace pendular
