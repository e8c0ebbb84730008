#pragma once

#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Fills cells that a table of points leaves empty below the value of a group, as a spreadsheet
/// does of merged cells: in columns of preshears, and in those that name materials, samples or the
/// like (`names_tests`). A preshear's shear stress is filled only where its normal stress is.
/// Returns a remark for each column.
/// @throws InputError at an empty cell between two different values in a column that repeats the
///         value in other rows, and at a preshear's where another group begins: it is not known
///         which value applies
std::vector<Remark> fill_down(Block& table);

}  // namespace pendular
