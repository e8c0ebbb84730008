#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>
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

/// Returns the correlation [1] between the rounding errors of two measurements of one quantity,
/// averaged over all positions of the true value between two rounded values; near 1 if `scatter` is
/// far below 1.
///     6/pi^2 sum_k exp(-(2 pi k scatter)^2)/k^2      (Fourier series of the rounding error)
/// @param scatter standard deviation before rounding over the rounding step [1]
double rounding_correlation(double scatter);

/// Sets `ReplicatedValue::rounding` = V/T [1] of rounded values, so that `analyse_scatter` gives
/// less weight to values whose deviations may be due to rounding. V is the relative variance of
/// that part of the rounding error which replicates do not share, and T the relative variance
/// between repetitions of a step: one each for stress ratio and solid fraction, chosen so that the
/// mean of squared deviation/(T + V) is 1.
/// Source: Paule and Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377.
void weigh_rounding(ReplicateTable& table, const std::vector<Reading>& readings);

/// Adds the variance of rounding, (rounding step)^2/12, to shear stress and solid fraction of each
/// reading, except where the stated variance is at least as large. The error that replicates share
/// is also added to `Reading::shared`.
/// @param stated variances given with each reading, rounding included: shear stress [Pa^2], solid
///         fraction [1]; 0: none
void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  std::vector<Reading>& readings);

}  // namespace pendular
