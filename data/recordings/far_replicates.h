#pragma once

#include <set>
#include <utility>
#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Replicates (repeated readings at one condition) that differ from each other far more than all
/// other replicates do.
struct FarReplicates {
    /// For each reading, variance to add to the error of the stress ratio (index 0) and of the
    /// solid fraction (index 1), divided by the squared value [1]. The variance is 0 for a reading
    /// that agrees with its replicates (repeated readings at one condition).
    std::vector<Eigen::Vector2d> variance;
    /// Clusters of files (connected by common conditions) whose files differ too much, if no single
    /// file can be identified as the wrong one. The first number of each pair is the index of the
    /// cluster in `ReplicateTable::clusters`. The second number is 0 for the stress ratio and 1 for
    /// the solid fraction. The error of a filling of the cell is estimated without these clusters.
    std::set<std::pair<std::size_t, Eigen::Index>> unlike;
    /// Messages about values that are probably wrong: one message for each cluster of files
    /// (connected by common conditions) whose files differ too much in stress ratio or in solid
    /// fraction, and one for each condition whose readings differ too much.
    std::vector<Doubt> doubts;
    /// Notes for the user: one note for each cluster of files (connected by common conditions)
    /// whose files differ clearly more than the steps of one file, but too little for an entry of
    /// `doubts`.
    std::vector<std::string> notes;
};

/// Finds replicates (repeated readings at one condition) that differ too much, and removes these
/// replicates from the table. Far replicates would otherwise increase the errors of all other
/// readings.
/// - Files differ too much if the standard deviation between the files of a cluster (connected by
///   common conditions) exceeds 5 % in stress ratio or 3 % in solid fraction. One file is removed
///   if the remaining files then agree. Otherwise all files stay, and `unlike` of the result lists
///   the cluster.
/// - A condition is removed if its replicates scatter more than the replicates of all other
///   conditions in its cluster of files (F test, p < 0.001).
FarReplicates set_far_replicates_apart(ReplicateTable& table, const std::vector<Reading>& readings);

}  // namespace pendular
