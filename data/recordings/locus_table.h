#pragma once

#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// First characters of every table that `locus_table` returns, by which the program recognises an
/// earlier table before a new one replaces it.
constexpr const char* locus_table_begin = "file,test,kind,points";

/// Returns the yield loci and wall yield loci of files as one CSV table, a row for each, with the
/// standard error of each result beside it. Cells of what is not known are empty. The angle
/// of wall friction is that of `WallLocus::line`, the adhesion that of the best line. Angles are in
/// degrees; all else is in SI units.
std::string locus_table(const std::vector<FileView>& views);

}  // namespace pendular
