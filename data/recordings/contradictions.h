#pragma once

#include <optional>
#include <set>
#include <string>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Rows of one recording in which two columns that measure one quantity, such as shear stress and
/// torque, contradict each other.
struct Contradictions {
    /// Line numbers, in the file, of the rows that were removed because two columns contradict each
    /// other.
    std::set<int> lines;
    /// Number of rows of the file whose mean is one row of the recording
    /// (`Recording::averaged_rows`).
    int averaged_rows = 1;
    /// Reason why no reading of the recording's file can be used. The reason is empty if readings
    /// can be used.
    std::optional<std::string> file;
};

/// Removes the rows of a recording in which two columns contradict each other, and returns the
/// removed rows. The pairs of columns are shear stress and torque, normal stress and normal force,
/// and shear rate and angular velocity. Values of a pair, converted with the radii of the cell, may
/// differ by the sum of 5 % and the resolution of both columns. If the median ratio of a pair
/// differs from 1 by more than 2 %, the whole file is doubtful, and no row is removed because of
/// this pair. A median ratio of shear rates between 0.5 and 2 causes only a note.
/// @param choice if `keep_implausible` is set, no row is removed and no file is refused
/// @param result receives the removed rows in `excluded`, and messages in `doubts` and `notes`
Contradictions take_out_contradictions(Recording& recording, const AnnularCell& cell,
                                       const ImportSettings& choice, Measurements& result);

/// Moves readings made from rows with contradictory columns from `part.readings` to
/// `part.excluded`. If the whole file is doubtful, all readings are moved. Otherwise only readings
/// that lost more than 1 in 100 of their rows are moved, since the mean over the remaining rows may
/// be biased.
/// @param contradictions removed rows of the recording, from `take_out_contradictions`
/// @param part readings that were made from the recording
void set_aside_contradicted(const Contradictions& contradictions, Measurements& part);

}  // namespace pendular
