#pragma once

#include <map>
#include <string>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Returns columns of a table of someone's own that are read as a quantity by their unit alone: a
/// quantity of steady shear is missing, and no other column has a unit that fits it. Set points,
/// columns of errors and of other kinds of tests are none, displacements no height, and forces no
/// lever's.
/// @return as `FileFormat::named_columns`: text of the column, by quantity
std::map<std::string, std::string> columns_by_unit(const BlockFile& file);

}  // namespace pendular
