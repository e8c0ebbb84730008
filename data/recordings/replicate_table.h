#pragma once

#include <array>
#include <string>
#include <vector>

#include "data/recordings/scatter.h"

namespace pendular {

/// Cluster of files that common conditions connect, directly or through further files.
struct ReplicateCluster {
    std::vector<std::size_t> files;  ///< indices in `ReplicateTable::files`
    /// Deviations in stress ratio (0) and solid fraction (1).
    std::array<std::vector<ReplicatedValue>, 2> values;
};

/// Readings of a study by file, by condition, and by cluster of files, with the deviations of
/// replicates from their mean.
struct ReplicateTable {
    /// Paths in the order of their first readings. A table that states errors of fillings is listed
    /// once for each filling, and counts as so many files.
    std::vector<std::string> files;
    std::vector<std::size_t> fillings;  ///< number of the filling in such a table; 0: a whole file
    std::vector<std::size_t> file_of;   ///< of each reading, index in `files`
    std::vector<std::size_t> cluster_of;           ///< of each reading, index in `clusters`
    std::vector<std::vector<std::size_t>> groups;  ///< readings at each condition, ascending
    std::vector<ReplicateCluster> clusters;        ///< every file is in one cluster
    double reference_stress = 1;  ///< geometric mean of the normal stresses of all readings [Pa]
    /// Range of the normal stresses of readings with replicates over `reference_stress` [1], which
    /// contains 1. Readings beyond get the scatter at its ends.
    double least_load = 1;
    double greatest_load = 1;

    /// Returns the name of a file without its folder, with the number of a filling of a table.
    std::string name_of(std::size_t file) const;
};

/// Returns the table. Deviations are differences of logarithms of stress ratio and solid fraction
/// [1], which hardly change if a normal stress is 2 % off its set point.
ReplicateTable replicate_table(const std::vector<Reading>& readings);

/// Returns the variance of the shear stress (i = 0) or solid fraction (i = 1) over its square [1].
double relative_variance(const Reading& reading, Eigen::Index i);

}  // namespace pendular
