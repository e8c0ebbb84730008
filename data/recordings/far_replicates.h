#pragma once

#include <set>
#include <utility>
#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Replicates (readings at the same condition) that differ from each other far more than all other
/// replicates do.
struct FarReplicates {
    /// For each reading, variance to add to (stress ratio, solid fraction) relative to the squared
    /// values [1]; 0 for readings that agree with their replicates.
    std::vector<Eigen::Vector2d> variance;
    /// Clusters of files (connected by common conditions) whose files differ so much that the wrong
    /// file cannot be identified. Each pair is (index of the cluster, 0 for stress ratio or 1 for
    /// solid fraction). The clusters are not used to estimate the error of fillings.
    std::set<std::pair<std::size_t, Eigen::Index>> unlike;
    /// Messages about values that are probably wrong: one for each cluster whose files, and one for
    /// each condition whose readings, differ too much in stress ratio or in solid fraction.
    std::vector<Doubt> doubts;
    /// Notes for the user: one for each cluster whose files differ less, but still remarkably.
    std::vector<std::string> notes;
};

/// Finds replicates (readings at the same condition) that differ too much, and removes them from
/// the table, so that they do not increase the errors of all other readings.
///
/// Files differ too much if the standard deviation between them exceeds 5 % in stress ratio or 3 %
/// in solid fraction. One file is removed if the other files then agree; otherwise all files stay
/// and their cluster is listed in `FarReplicates::unlike`. A condition is removed if its replicates
/// scatter more than the replicates of all other conditions (F test, p < 0.001). Files that differ
/// by more than half of the limits, and by more than three times the scatter of their steps, stay
/// in the table and cause a note.
FarReplicates set_far_replicates_apart(ReplicateTable& table, const std::vector<Reading>& readings);

}  // namespace pendular
