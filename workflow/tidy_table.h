#pragma once

#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Returns the data points of all intervals of a file of measurements as one CSV table in SI units.
/// The first row contains the names of the columns, the second their units: test, number and role
/// of the interval, line of the file, every quantity that an interval contains, and the stresses of
/// the preshear and the bulk density [kg/m^3] that intervals state. Cells without a value are
/// empty. Of several sheets, the test begins with the name of the sheet. Origin and pandas
/// (header=[0, 1]) can read the table.
std::string tidy_table(const std::vector<FileView>& views);

}  // namespace pendular
