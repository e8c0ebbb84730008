#pragma once

#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Returns a sentence that names the layout (arrangement of header, columns and rows) by which a
/// file of measurements is read, and states the numbers of intervals (steps of constant set points)
/// and rows in the file.
std::string file_sentence(const FileView& view);

/// Returns a sentence that states the character encoding, the delimiter of cells and the decimal
/// mark of a file of measurements.
std::string encoding_sentence(const FileView& view);

/// Returns a table of the columns of a file of measurements, one line per column below a heading. A
/// line states the name and the unit of the column, and the quantity that the program reads from
/// the column. If only some intervals (steps of constant set points) have the column, the line also
/// states their number.
std::vector<std::string> columns_table(const FileView& view);

/// Returns a table of the intervals (steps of constant set points) of a file of measurements, one
/// line per interval below a heading. The line states number, role in the test (such as preshear),
/// number of rows, line numbers in the file, median normal stress [Pa] (or normal force [N]),
/// largest shear stress [Pa] (or torque [N m]), and the reason for the role.
std::vector<std::string> intervals_table(const FileView& view);

/// Returns a heading and sentences on the checks of a file of measurements. One sentence for each
/// fault states the lines of the file, the fault, and the remedy that was applied. One sentence for
/// each kind of rows left out states the lines and the reason. If there is neither a fault nor a
/// row left out, one sentence says so.
/// @param all whether each sentence names all lines concerned; otherwise a sentence names at most 8
///        ranges of lines
std::vector<std::string> checks_lines(const FileView& view, bool all);

/// Returns tables of the yield loci in a file of measurements. Returns an empty list if the file
/// has no yield locus. Each table lists the normal stress and the shear stress [Pa] of the points
/// of failure, first at the data point of largest shear stress, second at the smoothed peak. Lines
/// below the points state results of the fitted straight line, such as cohesion and unconfined
/// strength [Pa].
std::vector<std::string> yield_locus_lines(const FileView& view);

/// Returns sentences on the quantities that readings of steady shear need but a file of
/// measurements lacks, such as the gap height. The last sentence asks the user to export these
/// quantities too. For a file with yield loci, the last sentence says instead that points of
/// failure need only the stresses. Returns an empty text if the file lacks no quantity, or if the
/// file is a report of yield loci.
std::string missing_sentence(const FileView& view);

}  // namespace pendular
