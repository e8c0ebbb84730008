#pragma once

#include <vector>

#include "data/reading.h"

namespace pendular {

/// Deviation of one reading from the mean of its replicates (repeated readings at one condition),
/// in stress ratio or in solid fraction.
struct ReplicatedValue {
    std::size_t reading = 0;  ///< index of the reading among the study's readings
    /// Index in `ReplicateTable::groups` of the condition of the reading and its replicates.
    std::size_t condition = 0;
    /// Index in `ReplicateTable::files` of the reading's file. A file counts as one filling.
    std::size_t file = 0;
    /// Logarithm of the stress ratio or solid fraction of the reading, minus the mean logarithm at
    /// the condition of the reading [1].
    double deviation = 0;
    /// Variance [1] of the stress ratio or solid fraction that follows from the scatter within the
    /// recorded step of the reading, divided by the squared value.
    double within = 0;
    /// Load of the reading [1]: normal stress divided by the reference stress of the study.
    double load = 1;
    /// Variance of the part of the rounding error that replicates (repeated readings at one
    /// condition) do not have in common, divided by the variance between repetitions of a step at
    /// load 1 [1].
    double rounding = 0;
};

/// Result of a two-way analysis of variance (by conditions and by files) of the relative deviations
/// [1] of readings from the mean of their replicates. Before the analysis, each deviation is
/// divided by sqrt(load^(-2 exponent) + rounding), with the members `load` and `rounding` of the
/// `ReplicatedValue`.
struct ScatterSums {
    /// Residual sum of squares of the scaled deviations, after the means of conditions and of files
    /// were removed [1].
    double within = 0;
    double freedom_within = 0;  ///< degrees of freedom of the residual sum of squares `within`
    /// Sum of squares between files [1]: reduction of the sum of squares of the scaled deviations
    /// if the means of files are removed after the means of conditions.
    double between = 0;
    double freedom_between = 0;  ///< degrees of freedom of the sum of squares `between`
    /// Squared norm of the design matrix of the files, after the means of conditions were removed.
    /// The squared norm divided by `freedom_between` is the effective number of conditions that two
    /// files have in common.
    double steps = 0;
    /// Contribution to the residual sum of squares `within` that is expected from the scatter
    /// within the recorded steps [1].
    double run_variance = 0;
    /// Residual of each scaled deviation after the means of conditions and of files were removed
    /// [1], in the order of the values.
    Eigen::VectorXd left_over;
    /// Mean deviation of each file from the mean of all files [1], by index of the file. The mean
    /// deviation is 0 for files without values.
    std::vector<double> of_file;
};

/// Performs a two-way analysis of variance (by conditions and by files) of deviations between
/// replicates (repeated readings at one condition). Common conditions must connect the files. If
/// conditions and files leave no degree of freedom, all scatter is attributed to the steps of a
/// recording, each of which gives one reading.
/// @param exponent exponent of the normal stress in the scatter [1]: standard deviation ~ (normal
///         stress)^-exponent
/// @param tell_files true: the scatter is divided between steps and files; false: all scatter is
///         attributed to steps
/// Source: Searle, Casella and McCulloch, Variance Components (1992), chapter 5.
ScatterSums analyse_scatter(const std::vector<ReplicatedValue>& values, double exponent,
                            bool tell_files = true);

/// Dependence of the scatter between replicates (repeated readings at one condition) on the load,
/// which is the normal stress divided by a reference stress:
///     standard deviation ~ load^-value
struct LoadExponent {
    double value = 0;           ///< most probable exponent of the load [1]
    double standard_error = 0;  ///< standard error of the load exponent [1]
    /// Difference of -2 log(likelihood times prior) between exponent 0 and the most probable
    /// exponent [1]. If the difference is large, the relative scatter depends on the load.
    double evidence = 0;
};

/// Returns the most probable exponent [1] of the load (normal stress divided by a reference stress)
/// in the scatter between replicates (repeated readings at one condition):
///     standard deviation ~ load^-exponent
/// One exponent holds for all sets of values, but each set has a variance of its own. The prior of
/// the exponent is normal with mean 0 and standard deviation 0.5, limited to the range from 0 to 1.
/// All members of the result are 0 for fewer than 10 degrees of freedom.
/// @param sets deviations of readings, one list for each set, such as a cluster of files
LoadExponent load_exponent(const std::vector<std::vector<ReplicatedValue>>& sets);

/// Mean square of relative deviations, which is an estimate of the variance of the deviations, with
/// the degrees of freedom of the mean square.
struct MeanSquare {
    double value = 0;    ///< mean square of the relative deviations [1]
    double freedom = 0;  ///< degrees of freedom of the mean square
};

/// Returns improved estimates of the mean squares of several sets of deviations, such as one set
/// for each cluster of files, in the order of the sets. If the sets do not differ significantly
/// (p > 0.005), all sets get the pooled mean square. Otherwise, a set with at least 5 degrees of
/// freedom keeps its own mean square, and the mean squares of smaller sets are shrunk towards a
/// common value.
/// @param own mean square of each set by itself
/// Source: Smyth, Stat. Appl. Genet. Mol. Biol. 3 (2004) 3, moderated variances.
std::vector<MeanSquare> moderated(const std::vector<MeanSquare>& own);

}  // namespace pendular
