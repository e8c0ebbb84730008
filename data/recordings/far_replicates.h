#pragma once

#include <set>
#include <utility>
#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Replicates (readings at the same condition) that differ far more than all other replicates
/// scatter.
struct FarReplicates {
    /// Variance to add to (stress ratio, solid fraction) of each reading, relative to the squared
    /// values [1]; 0 for readings that agree with their replicates.
    std::vector<Eigen::Vector2d> variance;
    /// Pairs (index of a cluster of files, 0: stress ratio or 1: solid fraction) to leave out of
    /// the pooled error of fillings: the cluster's files differ too much, and it is unknown which
    /// is wrong.
    std::set<std::pair<std::size_t, Eigen::Index>> unlike;
    /// One reason not to believe values for each cluster with far files and each far condition, in
    /// stress ratio or in solid fraction.
    std::vector<Doubt> doubts;
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
