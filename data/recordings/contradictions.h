#pragma once

#include <optional>
#include <set>
#include <string>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/study/study.h"

namespace pendular {

/// Contradictions between the columns of one recording.
struct Contradictions {
    std::set<int> lines;              ///< of rows that are at odds with the rest of the file
    std::optional<std::string> file;  ///< why none of the file can be relied on
};

/// Compares shear stress with torque, normal stress with normal force and shear rate with angular
/// velocity, where a recording holds both, through the factors of the cell. A row contradicts where
/// they differ by more than 5 % and by more than the resolution of the columns. A factor that is
/// common to the file by more than 2 % means another cell or formula: all of the file is in doubt,
/// but for shear rates within a factor of two, which instruments take at other radii.
///
/// Doubts and notes go to `result`; the rows that contradict are taken out of the recording, unless
/// the choice keeps them.
Contradictions take_out_contradictions(Recording& recording, const AnnularCell& cell,
                                       const ImportSettings& choice, Measurements& result);

/// Sets aside the readings of a recording that its contradictions spoil: all of them, or those with
/// more than 1 in 100 of their rows taken out, since what is left is no fair sample.
void set_aside_contradicted(const Contradictions& contradictions, Measurements& part);

}  // namespace pendular
