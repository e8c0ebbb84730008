#pragma once

#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Sentence on the layout of a file of measurements, and the numbers of its intervals and rows.
std::string file_sentence(const FileView& view);

/// Sentence on the encoding, the delimiter of cells and the decimal mark of a file of measurements.
std::string encoding_sentence(const FileView& view);

/// Table of the columns of a file of measurements, one line per column below a heading: name, unit,
/// the quantity as which the column is read, and in how many intervals it occurs.
std::vector<std::string> columns_table(const FileView& view);

/// Table of the intervals of a file of measurements, one line per interval below a heading: number,
/// role, rows, lines, median normal stress [Pa] (or normal force [N]), largest shear stress [Pa]
/// (or torque [N m]), and the reason for the role.
std::vector<std::string> intervals_table(const FileView& view);

/// Heading and sentences on what the checks of a file of measurements found: lines of the file,
/// what is wrong, and what was done. A sentence says so if the checks found nothing.
/// @param all whether all lines of the file are named; otherwise at most 8 ranges of lines for each
///        finding
std::vector<std::string> checks_lines(const FileView& view, bool all);

/// Tables of the yield loci of a file of measurements: the points of failure, by the sample of
/// largest shear stress and by the smoothed peak [Pa], and what follows from the line through them,
/// such as cohesion and unconfined strength [Pa]. Empty where the file has no yield locus.
std::vector<std::string> yield_locus_lines(const FileView& view);

/// Sentence on the quantities that readings of steady shear need and a file of measurements lacks,
/// and on what can be done nevertheless; empty if the file has all these quantities.
std::string missing_sentence(const FileView& view);

}  // namespace pendular
