#pragma once

#include <set>
#include <utility>
#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Replicates (repeated readings at one condition) that differ from each other far more than all
/// other replicates do.
struct FarReplicates {
    /// Relative variances [1] to add to the errors of each reading, for the stress ratio (index 0)
    /// and the solid fraction (index 1): variance divided by the squared value. The variances are 0
    /// for readings that agree with their replicates (repeated readings at one condition).
    std::vector<Eigen::Vector2d> variance;
    /// Clusters of files (connected by common conditions) whose files differ too much, if no single
    /// file can be identified as the wrong one. The first number of each pair is the index of the
    /// cluster. The second number is 0 for the stress ratio and 1 for the solid fraction. These
    /// clusters do not contribute to the estimated error of fillings.
    std::set<std::pair<std::size_t, Eigen::Index>> unlike;
    /// Messages about values that are probably wrong: one message for each cluster of files
    /// (connected by common conditions) whose files differ too much in stress ratio or in solid
    /// fraction, and one for each condition whose readings differ too much.
    std::vector<Doubt> doubts;
    /// Notes for the user: one note for each cluster of files (connected by common conditions)
    /// whose files differ remarkably, but too little for an entry of `doubts`.
    std::vector<std::string> notes;
};

/// Finds replicates (repeated readings at one condition) that differ too much, and removes them
/// from the table. Far replicates would otherwise increase the errors of all other readings.
/// - Files differ too much if the standard deviation between them exceeds 5 % in stress ratio or
///   3 % in solid fraction. One file is removed if the remaining files then agree. Otherwise all
///   files stay, and `unlike` of the result lists their cluster.
/// - A condition is removed if its replicates scatter more than the replicates of all other
///   conditions in its cluster of files (F test, p < 0.001).
FarReplicates set_far_replicates_apart(ReplicateTable& table, const std::vector<Reading>& readings);

}  // namespace pendular
