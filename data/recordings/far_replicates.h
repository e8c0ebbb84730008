#pragma once

#include <set>
#include <utility>
#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Replicates that differ from each other far more than all others do. Pairs of values are those of
/// stress ratio (0) and solid fraction (1).
struct FarReplicates {
    /// Relative variance to add to the error of each reading [1]; 0 where it agrees with its
    /// replicates.
    std::vector<Eigen::Vector2d> variance;
    /// Clusters, by index in `ReplicateTable::clusters` and 0 or 1 for the value, whose files
    /// differ too much without a single one that is wrong. Filling errors are estimated without
    /// them.
    std::set<std::pair<std::size_t, Eigen::Index>> unlike;
    /// One for each cluster or condition that differs too much, and one for each cluster whose
    /// files differ clearly more than the steps of a file, but too little for a doubt.
    std::vector<Remark> remarks;
};

/// Finds replicates that differ too much, and removes them from the table, where they would
/// increase the errors of all other readings.
/// - Files of a cluster differ too much if the standard deviation between them exceeds 5 % in
///   stress ratio or 3 % in solid fraction. One file is removed if the others then agree; otherwise
///   all stay, and `unlike` lists the cluster.
/// - A condition is removed if its replicates scatter more than those of all other conditions of
///   its cluster (F test, p < 0.001).
FarReplicates set_far_replicates_apart(ReplicateTable& table, const std::vector<Reading>& readings);

}  // namespace pendular
