#pragma once

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Number that data loggers write where they have no value.
constexpr double usual_missing_value = -9999;

/// Clears the cells of a file that hold no value: marks (`marks_no_value`), the values that the
/// user
/// (`FileFormat::missing`) or the header ("missing value: -999") declares, and -9999 in a column
/// that has no other value below half of it. A number as low as that would else be averaged with
/// measured values.
/// @param cleared list to which the cells are added; null: none
void clear_missing_values(BlockFile& file, const FileFormat& format,
                          std::vector<ClearedCell>* cleared = nullptr);

}  // namespace pendular
