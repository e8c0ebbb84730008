#pragma once

#include <array>
#include <string>
#include <vector>

#include "data/recordings/scatter.h"

namespace pendular {

/// Cluster of files that are connected by common conditions (normal stress, inertial number and
/// liquid content), directly or through further files.
struct ReplicateCluster {
    /// Indices of the cluster's files in `ReplicateTable::files`.
    std::vector<std::size_t> files;
    /// Deviations of readings from the mean of their replicates (repeated readings at one
    /// condition), in the stress ratio (index 0) and the solid fraction (index 1).
    std::array<std::vector<ReplicatedValue>, 2> values;
};

/// Readings of a study, grouped by file, by condition (normal stress, inertial number and liquid
/// content), and by cluster of files that are connected by common conditions.
struct ReplicateTable {
    /// Paths of the files that contain readings, in the order of the files' first readings.
    std::vector<std::string> files;
    /// For each reading, index in `files` of the file that contains the reading.
    std::vector<std::size_t> file_of;
    /// For each reading, index in `clusters` of the cluster that contains the reading's file.
    std::vector<std::size_t> cluster_of;
    /// For each condition, indices of the readings at the condition, in ascending order.
    std::vector<std::vector<std::size_t>> groups;
    /// Clusters of files that common conditions connect. Every file is in one cluster.
    std::vector<ReplicateCluster> clusters;
    double reference_stress = 1;  ///< geometric mean of the normal stresses of all readings [Pa]
    /// Smallest normal stress of the readings with replicates (repeated readings at one condition),
    /// divided by `reference_stress` [1]; at most 1. Readings at smaller normal stresses get the
    /// scatter that replicates have at this normal stress.
    double least_load = 1;
    /// Largest normal stress of the readings with replicates (repeated readings at one condition),
    /// divided by `reference_stress` [1]; at least 1. Readings at larger normal stresses get the
    /// scatter that replicates have at this normal stress.
    double greatest_load = 1;

    /// Returns the name, without the folder, of the file with index `file` in `files`.
    std::string name_of(std::size_t file) const;
};

/// Groups readings by file, by condition and by cluster of files (connected by common conditions).
/// Computes how far replicates (repeated readings at one condition) deviate from their mean.
/// Deviations are differences of the logarithms of stress ratio and solid fraction [1], which
/// hardly change if a normal stress is 2 % off its set point.
ReplicateTable replicate_table(const std::vector<Reading>& readings);

/// Returns the variance of a reading's shear stress (i = 0) or solid fraction (i = 1), divided by
/// the squared value [1].
double relative_variance(const Reading& reading, Eigen::Index i);

}  // namespace pendular
