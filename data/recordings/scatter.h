#pragma once

#include <vector>

#include "data/reading.h"

namespace pendular {

/// Deviation of one reading from the mean of its replicates, in stress ratio or in solid fraction.
/// Variances are relative: over the squared value.
struct ReplicatedValue {
    std::size_t reading = 0;    ///< index among the study's readings
    std::size_t condition = 0;  ///< index in `ReplicateTable::groups`
    std::size_t file = 0;       ///< index in `ReplicateTable::files`; a file counts as one filling
    double deviation = 0;       ///< logarithm of the value, minus its mean at the condition [1]
    double within = 0;          ///< variance from the scatter within the recorded step [1]
    double load = 1;            ///< normal stress over the reference stress of the study [1]
    /// Variance of that part of the rounding error which replicates do not share, over the variance
    /// between repetitions of a step at load 1 [1].
    double rounding = 0;
};

/// Two-way analysis of variance, by conditions and by files, of deviations that were each divided
/// by sqrt(load^(-2 exponent) + rounding); all members are numbers [1].
struct ScatterSums {
    double within = 0;           ///< residual sum of squares, without means of conditions and files
    double freedom_within = 0;   ///< degrees of freedom of `within`
    double between = 0;          ///< decrease of the sum by the means of files, after conditions
    double freedom_between = 0;  ///< degrees of freedom of `between`
    /// Squared norm of the design matrix of the files without the means of conditions; over
    /// `freedom_between`, the effective number of conditions that two files have in common.
    double steps = 0;
    double run_variance = 0;    ///< part of `within` expected from the scatter within the steps
    Eigen::VectorXd left_over;  ///< residuals, in the order of the values
};

/// Returns the analysis of variance of deviations between replicates. Common conditions must
/// connect the files. If conditions and files leave no degree of freedom, all scatter counts as
/// that of steps.
/// @param exponent standard deviation ~ load^-exponent
/// @param tell_files false: all scatter counts as that of steps
/// Source: Searle, Casella and McCulloch, Variance Components (1992), chapter 5.
ScatterSums analyse_scatter(const std::vector<ReplicatedValue>& values, double exponent,
                            bool tell_files = true);

/// Most probable exponent of the scatter between replicates, standard deviation ~ load^-value [1].
struct LoadExponent {
    double value = 0;
    double standard_error = 0;
    double evidence = 0;  ///< fall of -2 log(likelihood times prior) from exponent 0 to `value`
};

/// Returns the most probable exponent [1]. It holds for all sets, such as clusters of files, each
/// of which has a variance of its own. The prior is normal with mean 0 and standard deviation 0.5,
/// from 0 to 1. All members are 0 for fewer than 10 degrees of freedom.
LoadExponent load_exponent(const std::vector<std::vector<ReplicatedValue>>& sets);

/// Mean square of relative deviations [1], with its degrees of freedom.
struct MeanSquare {
    double value = 0;
    double freedom = 0;
};

/// Returns improved estimates of the mean squares of several sets, such as clusters of files. If
/// the sets do not differ significantly (p > 0.005), all get the pooled one. Otherwise, a set with
/// at least 5 degrees of freedom keeps its own, and those of smaller sets are shrunk towards a
/// common value.
/// Source: Smyth, Stat. Appl. Genet. Mol. Biol. 3 (2004) 3, moderated variances.
std::vector<MeanSquare> moderated(const std::vector<MeanSquare>& own);

}  // namespace pendular
