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
    std::set<int> lines;              ///< lines of the rows that contradict the rest of the file
    std::optional<std::string> file;  ///< why none of the file can be relied on
};

/// Compares shear stress with torque, normal stress with normal force and shear rate with angular
/// velocity, where a recording holds both, through the factors of the cell. A row contradicts
/// itself where they differ by more than 5 % and by more than the resolution of the columns. A
/// factor of more than 2 % that all rows share means that the instrument used another cell or
/// formula: the whole file is doubted. Shear rates are exempt up to a factor of two, since
/// instruments refer them to different radii.
///
/// Doubts and notes go to `result`; contradicting rows are taken out of the recording, unless
/// `choice` keeps implausible values.
Contradictions take_out_contradictions(Recording& recording, const AnnularCell& cell,
                                       const ImportSettings& choice, Measurements& result);

/// Sets aside the readings that contradictions make unusable: all of a recording that is doubted as
/// a whole, else those that lost more than 1 in 100 of their rows, since the remaining rows are no
/// fair sample.
void set_aside_contradicted(const Contradictions& contradictions, Measurements& part);

}  // namespace pendular
