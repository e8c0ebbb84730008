#pragma once

#include <set>
#include <utility>
#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Replicates that differ far beyond the scatter of the others.
struct FarReplicates {
    /// Variance to add to (stress ratio, solid fraction) of each reading, relative to their
    /// squares [1]; 0 for readings that agree with their replicates.
    std::vector<Eigen::Vector2d> variance;
    /// Clusters and observables that are left out of the pooled error of fillings: their files
    /// differ far too much, and it is unknown which of them is wrong.
    std::set<std::pair<std::size_t, Eigen::Index>> unlike;
    std::vector<Doubt> doubts;       ///< one for each file or condition found
    std::vector<std::string> notes;  ///< one for each cluster whose files differ remarkably
};

/// Finds files whose values differ from those of their replicates by more than 5 % in stress ratio
/// or 3 % in solid fraction (standard deviation of fillings), and conditions whose replicates
/// scatter more than all others (F test, p < 0.001 for the study). Their values leave the table, so
/// that they do not widen the errors of the others. Files that differ by half of that, and three
/// times as much as their own steps scatter, stay and are noted.
FarReplicates set_far_replicates_apart(ReplicateTable& table, const std::vector<Reading>& readings);

}  // namespace pendular
