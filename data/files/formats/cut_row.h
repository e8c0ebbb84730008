#pragma once

#include <string_view>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Leaves out the last row of a file without a line end behind it, if the file ended within its
/// last number: "4" below "40.05". Such a row has as many cells as the others, but its number is
/// another one.
///
/// Many programs write no last line end, so that this shows nothing by itself. A number counts as
/// cut where it has fewer decimals than all others of its column, or fewer digits and less than a
/// quarter of their smallest magnitude. A column without a fixed number of decimals has such a
/// number by chance in one of as many files as it has rows, which then lose one row of many.
/// @param last_line number of the last line of the file
void leave_out_cut_row(BlockFile& file, int last_line);

/// Whether the number in `cell` may be the begin of one such as `other`, as `leave_out_cut_row`
/// judges it.
bool may_be_cut(std::string_view cell, std::string_view other);

}  // namespace pendular
