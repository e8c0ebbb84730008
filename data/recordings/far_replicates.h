#pragma once

#include <set>
#include <utility>
#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Replicates that differ far more than the scatter of all other replicates.
struct FarReplicates {
    /// Variance to add to (stress ratio, solid fraction) of each reading, relative to the squared
    /// values [1]; 0 for readings that agree with their replicates.
    std::vector<Eigen::Vector2d> variance;
    /// Pairs of cluster and observable to leave out of the pooled error of fillings: the files of
    /// the cluster differ too much, and it is unknown which file is wrong.
    std::set<std::pair<std::size_t, Eigen::Index>> unlike;
    std::vector<Doubt> doubts;  ///< one doubt for each group of far files and each far condition
    std::vector<std::string> notes;  ///< one note for each cluster whose files differ remarkably
};

/// Finds replicates that differ far too much, and removes them from the table, so that they do not
/// widen the errors of all other readings.
///
/// Far files: the standard deviation between files exceeds 5 % in stress ratio or 3 % in solid
/// fraction. One file is removed if the other files then agree; else all stay and the cluster is
/// listed in `unlike`. Far conditions: replicates scatter more than at all other conditions (F
/// test, p < 0.001). Files that differ by more than half of the limits, and by more than three
/// times the scatter of their steps, stay in the table and make a note.
FarReplicates set_far_replicates_apart(ReplicateTable& table, const std::vector<Reading>& readings);

}  // namespace pendular
