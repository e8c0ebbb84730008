#pragma once

#include <optional>
#include <set>
#include <string>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Contradictions between columns of one recording that hold the same quantity.
struct Contradictions {
    std::set<int> lines;    ///< lines in the file of the rows that were removed
    int averaged_rows = 1;  ///< `Recording::averaged_rows` of the recording
    /// Reason to use no reading of the recording's file; empty if there is none.
    std::optional<std::string> file;
};

/// Removes the rows of a recording whose columns contradict each other, and returns the
/// contradictions found. Doubts (reasons not to believe values) and notes are added to `result`. If
/// `choice` keeps implausible values, no row is removed.
///
/// Compared are the columns shear stress with torque, normal stress with normal force and shear
/// rate with angular velocity, converted with the cell. A row contradicts itself if the two values
/// differ by more than 5 % and by more than the resolution of the columns. A median ratio that
/// differs from 1 by more than 2 % means that the instrument used another cell or formula, so the
/// whole file is doubtful. For shear rates, a ratio between 0.5 and 2 only makes a note, since
/// instruments define the shear rate at different radii.
Contradictions take_out_contradictions(Recording& recording, const AnnularCell& cell,
                                       const ImportSettings& choice, Measurements& result);

/// Moves the readings that contradictions make unusable to `part.excluded`: all readings if the
/// whole file is doubtful, else the readings that lost more than 1 in 100 of their rows, since the
/// remaining rows are a biased sample.
void set_aside_contradicted(const Contradictions& contradictions, Measurements& part);

}  // namespace pendular
