#pragma once

#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Sentence on what a file is: layout, intervals, rows.
std::string file_sentence(const FileView& view);

/// Sentence on encoding, delimiter and decimal mark of a file.
std::string encoding_sentence(const FileView& view);

/// Table of the columns of all intervals of a file, with their units and the quantities that they
/// are read as.
std::vector<std::string> columns_table(const FileView& view);

/// Table of the intervals of a file: number, role, rows, lines, median normal stress [Pa] (or force
/// [N]), largest shear stress [Pa] (or torque [N m]) and the reason for the role.
std::vector<std::string> intervals_table(const FileView& view);

/// Heading and sentences on what the checks of a file found: lines of the file, what is wrong, and
/// what was done.
/// @param all whether all lines of the file are named; otherwise at most 8 ranges of lines for each
///        finding
std::vector<std::string> checks_lines(const FileView& view, bool all);

/// Tables of the yield loci of a file: points of failure by the sample of largest shear stress and
/// by the smoothed peak, the lines through them and what follows from these lines.
std::vector<std::string> yield_locus_lines(const FileView& view);

/// Sentence on the quantities that steady shear needs and the file lacks, with what can be done all
/// the same; empty if the file lacks none.
std::string missing_sentence(const FileView& view);

}  // namespace pendular
