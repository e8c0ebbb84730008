#pragma once

#include "data/files/formats/block_file.h"

namespace pendular {

/// Takes a title and other lines above the names of a table's columns off the lines of a file: they
/// become blank, and what they state ("Inner radius: 21 mm", or a key and a value in two cells)
/// becomes facts of `file`. The names are the line, above the first rows of numbers, that has at
/// most one cell less than these, and of several such lines the one with the most names of
/// quantities. Lines are left alone where no line is that, or where the names come first.
void take_preamble(SourceLines& source, BlockFile& file);

/// Whether the lines of a sheet hold a table of measurements: a row of numbers below a line in
/// which a cell names a quantity.
bool holds_table(const SourceLines& source);

}  // namespace pendular
