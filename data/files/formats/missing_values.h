#pragma once

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Whether data loggers write a number where they have no value: -9999, and -999.25, -9999.25 and
/// -99999, as logs of boreholes and of weather do.
constexpr bool is_usual_missing_value(double number) {
    return number == -9999 || number == -999.25 || number == -9999.25 || number == -99999;
}

/// Clears the cells of a file that hold no value: marks (`marks_no_value`), the values that the
/// user (`FileFormat::missing`) or the header ("missing value: -999") declares, and the usual
/// number
/// (`is_usual_missing_value`) in a column that has no other value below half of it. A number as low
/// as that would else be averaged with measured values.
/// @param cleared list to which the cells are added; null: none
void clear_missing_values(BlockFile& file, const FileFormat& format,
                          std::vector<ClearedCell>* cleared = nullptr);

}  // namespace pendular
