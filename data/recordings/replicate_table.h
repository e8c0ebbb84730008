#pragma once

#include <array>
#include <string>
#include <vector>

#include "data/recordings/scatter.h"

namespace pendular {

/// Files that are connected through common conditions, with the relative deviations [1] of their
/// values from the mean of each condition.
struct ReplicateCluster {
    std::vector<std::size_t> files;
    /// By observable: 0 stress ratio, 1 solid fraction.
    std::array<std::vector<ReplicatedValue>, 2> values;
};

/// Readings sorted by file, by condition and by clusters of files.
struct ReplicateTable {
    std::vector<std::string> files;                ///< in the order in which they appear
    std::vector<std::size_t> file_of;              ///< file of each reading
    std::vector<std::size_t> cluster_of;           ///< cluster of each reading
    std::vector<std::vector<std::size_t>> groups;  ///< readings of each condition
    std::vector<ReplicateCluster> clusters;
    double reference_stress = 1;  ///< geometric mean of the normal stress [Pa]
    double least_load = 1;     ///< smallest normal stress with replicates, over the reference [1]
    double greatest_load = 1;  ///< largest normal stress with replicates, over the reference [1]

    /// Name of a file without its folder.
    std::string name_of(std::size_t file) const;
};

/// Sorts readings into the table. Replicates are compared by the logarithms of stress ratio and
/// solid fraction [1], because neither changes with a normal stress that is 2 % off its set point.
ReplicateTable replicate_table(const std::vector<Reading>& readings);

/// Variance of observable `i` over the square of its value [1].
double relative_variance(const Reading& reading, Eigen::Index i);

}  // namespace pendular
