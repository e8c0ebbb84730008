#pragma once

#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// First characters of every table that `tidy_table` returns.
constexpr const char* tidy_table_begin = "test,interval,role,line";

/// Rows of all intervals of a file as the text of one CSV table in SI units, with a row of names
/// and a row of units, as Origin and pandas (header=[0, 1]) read it. Columns are test, interval,
/// role, line of the file, and the quantities that any interval has; cells without a value are
/// empty.
std::string tidy_table(const FileView& view);

}  // namespace pendular
