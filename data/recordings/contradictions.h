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
    /// Line numbers of the rows that were removed because two columns contradict each other.
    std::set<int> lines;
    /// Number of rows of the file whose mean is one row of the recording
    /// (`Recording::averaged_rows`).
    int averaged_rows = 1;
    /// Reason why no reading of the recording's file can be used. The reason is empty if readings
    /// can be used.
    std::optional<std::string> file;
};

/// Compares the columns of a recording that measure one quantity, removes the rows in which the
/// columns contradict each other, and returns the removed rows. Shear stress is compared with
/// torque, normal stress with normal force, and shear rate with angular velocity; the radii of the
/// cell convert one to the other. The function also lists the removed rows in `result.excluded`,
/// and adds messages about the contradictions to `result.doubts` and `result.notes`. If
/// `choice.keep_implausible` is set, no row is removed and no file is refused.
///
/// Two values in a row contradict each other if they differ by more than the sum of 5 % and the
/// resolution of the two columns. If the median ratio of the two columns differs from 1 by more
/// than 2 %, the instrument used another cell or formula than the study, and the whole file is
/// doubtful: `Contradictions::file` gives the reason, and no row is removed. A median ratio of
/// shear rates between 0.5 and 2 causes only a note, since instruments define the shear rate at
/// different radii.
Contradictions take_out_contradictions(Recording& recording, const AnnularCell& cell,
                                       const ImportSettings& choice, Measurements& result);

/// Moves readings from `part.readings` to `part.excluded` if two columns contradict each other in
/// rows of the readings. If the whole file is doubtful, all readings are moved. Otherwise only
/// readings that lost more than 1 in 100 of their rows are moved, since the mean over the remaining
/// rows may be biased.
void set_aside_contradicted(const Contradictions& contradictions, Measurements& part);

}  // namespace pendular
