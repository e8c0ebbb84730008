#pragma once

#include <vector>

#include "data/reading.h"

namespace pendular {

/// Stress ratio or solid fraction of a reading that has replicates (readings at the same
/// condition), as deviation from their mean.
struct ReplicatedValue {
    std::size_t reading = 0;    ///< index of the reading
    std::size_t condition = 0;  ///< index of the condition that the replicates share
    std::size_t file = 0;       ///< index of the file; its readings are of one filling of the cell
    double deviation = 0;       ///< logarithm of the value less its mean at the condition [1]
    /// Variance of the value from the scatter within its recorded step, over the squared value [1].
    double within = 0;
    double load = 1;  ///< normal stress over the reference stress of the study [1]
    /// Variance of the rounding error that differs between replicates, over the variance between
    /// repetitions of a step at load 1 [1].
    double rounding = 0;
};

/// Result of a two-way analysis of variance (conditions and files) of relative deviations [1], each
/// divided by sqrt(load^(-2 exponent) + rounding).
struct ScatterSums {
    double within = 0;           ///< residual sum of squares after conditions and files
    double freedom_within = 0;   ///< degrees of freedom of `within`
    double between = 0;          ///< reduction of the sum of squares by files, after conditions
    double freedom_between = 0;  ///< degrees of freedom of `between`
    double steps = 0;            ///< squared norm of the files' design matrix, after conditions
    /// Expected part of `within` that the variances within the recorded steps explain.
    double run_variance = 0;
    /// Residual of each deviation after conditions and files, divided as the deviations are [1].
    Eigen::VectorXd left_over;
    /// Shift of each file, by index of the file, less the mean shift of all files [1]; 0 for files
    /// without values.
    std::vector<double> of_file;
};

/// Two-way analysis of variance (conditions, files) of values from files that are connected by
/// common conditions. If conditions and files leave no degree of freedom, all scatter is attributed
/// to steps.
/// Source: Searle, Casella and McCulloch, Variance Components (1992), chapter 5.
/// @param exponent load exponent of the scatter: standard deviation ~ load^-exponent [1]
/// @param tell_files whether scatter is attributed to files too; false: to steps only
ScatterSums analyse_scatter(const std::vector<ReplicatedValue>& values, double exponent,
                            bool tell_files = true);

/// Dependence of the scatter between replicates on the normal stress: standard deviation ~
/// load^-value, with load the normal stress over a reference stress.
struct LoadExponent {
    double value = 0;           ///< most probable exponent [1]
    double standard_error = 0;  ///< standard error of the exponent [1]
    /// Increase of -2 log(likelihood times prior) from the most probable exponent to 0 [1].
    double evidence = 0;
};

/// Most probable exponent in standard deviation ~ load^-exponent, common to several sets of values,
/// each set with a variance of its own. The prior is normal with mean 0 and standard deviation 0.5
/// [1], without exponents below 0 and above 1: errors of an instrument are constant or
/// proportional, so relative errors fall at most as 1/load. Returns zeros for fewer than 10 degrees
/// of freedom.
LoadExponent load_exponent(const std::vector<std::vector<ReplicatedValue>>& sets);

/// Mean square of relative deviations, an estimate of their variance.
struct MeanSquare {
    double value = 0;    ///< mean square [1]
    double freedom = 0;  ///< degrees of freedom of `value`
};

/// Improved estimates of the mean squares of several sets. All sets get the pooled mean square if
/// Bartlett's test finds no difference (p > 0.02). Otherwise a set with at least 5 degrees of
/// freedom keeps its own mean square, and the mean squares of smaller sets are shrunk towards the
/// common value, the more the better the sets agree.
/// Source: Smyth, Stat. Appl. Genet. Mol. Biol. 3 (2004) 3, moderated variances.
std::vector<MeanSquare> moderated(const std::vector<MeanSquare>& own);

}  // namespace pendular
