#pragma once

#include <vector>

#include "data/reading.h"

namespace pendular {

/// One value of a reading, with its deviation from the mean of its condition.
struct ReplicatedValue {
    std::size_t reading = 0;    ///< its place among the readings
    std::size_t condition = 0;  ///< readings of one condition replicate each other
    std::size_t file = 0;       ///< readings of one file are of one filling
    double deviation = 0;       ///< value over the mean of its condition, less 1 [1]
    double within = 0;          ///< variance within its run, relative to the value [1]
    double load = 1;            ///< normal stress over the reference [1]
    /// Variance of the rounding errors that differ between replicates, over the variance of a step
    /// at load 1 [1].
    double rounding = 0;
};

/// Two-way analysis of variance (conditions and files) of relative deviations, each divided by
/// sqrt(load^(-2 exponent) + rounding) [1].
struct ScatterSums {
    double within = 0;          ///< sum of squares left by conditions and files
    double freedom_within = 0;  ///< degrees of freedom of `within`
    double between = 0;  ///< reduction of the sum of squares by the files, adjusted for conditions
    double freedom_between = 0;
    double steps = 0;  ///< trace of the files' design matrix, adjusted for conditions
    /// Part of the mean square at load 1 that the variances within runs explain, times
    /// freedom_within.
    double run_variance = 0;
    Eigen::VectorXd left_over;    ///< residual of each value, in the same units
    std::vector<double> of_file;  ///< shift of each file about their mean, by file; 0 if not there
};

/// Analyses values whose files are connected through common conditions. Where conditions and files
/// leave no degree of freedom, files are not told apart from steps.
/// Source: Searle, Casella and McCulloch, Variance Components (1992), chapter 5.
/// @param tell_files false: all scatter is attributed to steps
ScatterSums analyse_scatter(const std::vector<ReplicatedValue>& values, double exponent,
                            bool tell_files = true);

/// How scatter depends on load: standard deviation ~ load^-value.
struct LoadExponent {
    double value = 0;           ///< [1]
    double standard_error = 0;  ///< [1]
    double evidence = 0;  ///< rise of -2 log(likelihood times prior) with an exponent of 0 [1]
};

/// Exponent that is most probable for these sets of values, each with a variance of its own, with a
/// prior of 0 +- 0.5 [1] that leaves out exponents below 0: an instrument's errors are constant or
/// proportional, so relative ones do not grow with load. All 0 where fewer than 10 degrees of
/// freedom tell.
LoadExponent load_exponent(const std::vector<std::vector<ReplicatedValue>>& sets);

/// Mean square of relative deviations [1]: an estimate of their variance, with its degrees of
/// freedom.
struct MeanSquare {
    double value = 0;
    double freedom = 0;
};

/// Estimates the mean square [1] of each set. All sets share one where Bartlett's test finds no
/// difference (p > 0.02). Otherwise a set with 5 degrees of freedom or more keeps its own; the
/// others are shrunk towards the common value, the more the better the sets agree. Source: Smyth,
/// Stat. Appl. Genet. Mol. Biol. 3 (2004) 3, moderated variances.
std::vector<MeanSquare> moderated(const std::vector<MeanSquare>& own);

}  // namespace pendular
