#pragma once

#include <optional>
#include <set>
#include <string>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Rows of one recording in which two columns that measure one quantity contradict each other.
struct Contradictions {
    std::set<int> lines;              ///< lines of the removed rows
    int averaged_rows = 1;            ///< `Recording::averaged_rows`
    std::optional<std::string> file;  ///< why the whole file is doubtful; empty: it is not
};

/// Removes the rows of a recording in which two columns contradict each other, and returns them.
/// The pairs are shear stress and torque, normal stress and normal force, and shear rate and
/// angular velocity. Values of a pair, converted with the radii of the cell, may differ by the sum
/// of 5 % and the resolution of both columns. If their median ratio differs from 1 by more than
/// 2 %, the whole file is doubtful, and no row is removed for this pair; a median ratio of shear
/// rates between 0.5 and 2 causes only a note.
/// @param choice with `keep_implausible`, no row is removed and no file is refused
/// @param result receives the rows in `excluded`, and messages in `doubts` and `notes`
Contradictions take_out_contradictions(Recording& recording, const AnnularCell& cell,
                                       const ImportSettings& choice, Measurements& result);

/// Moves the readings of a recording that contradictions spoil from `part.readings` to
/// `part.excluded`: all of a doubtful file, otherwise those that lost more than 1 in 100 of their
/// rows, since the mean over the remaining rows may be biased.
void set_aside_contradicted(const Contradictions& contradictions, Measurements& part);

}  // namespace pendular
