#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Quantity that varies between readings, such as the normal stress, along which residuals are
/// checked.
struct Covariate {
    std::string name;
    /// Value of the quantity at each entry (one observable of one reading, or a direct
    /// measurement); not a number where it is unknown.
    Eigen::VectorXd values;
};

/// Result of one test whether the residuals of a fitted model are consistent with the errors of
/// readings and prediction alone.
struct Check {
    enum class Kind {
        lack_of_fit,  ///< lack of fit of the conditions' means
        score,        ///< sum of a calibrated parameter's scores, cumulated along a covariate
        trend,        ///< increase or decrease of an observable's residuals with a covariate
        runs,         ///< few changes of sign between successive residuals
        neighbours    ///< correlation between the residuals of neighbouring conditions
    };
    Kind kind = Kind::lack_of_fit;
    /// Name of the covariate that the check uses; empty: none. A check of neighbours uses all
    /// covariates: "all, length 0.3", with the length of its kernel.
    std::string covariate = {};
    std::string of = {};  ///< parameter or observable that is checked, by name; empty: all
    /// Test statistic, as `check_fit` defines it for this kind of check; only the statistic of a
    /// trend has a sign.
    double statistic = 0;
    double p = 1;  ///< p value: probability of a statistic as large if the model is right [1]
};
/// Name of a kind of check for output, such as "lack of fit".
std::string_view to_string(Check::Kind kind);

/// All checks of the residuals of one fit, with a p value for all together.
struct Checks {
    /// The checks, one for each kind, covariate and parameter or observable.
    std::vector<Check> all;
    /// p value of all checks together [1]: probability that the smallest p value of any check is at
    /// least as small as observed if the model is right.
    double p = 1;
};

/// Observable and condition of each measured entry, as checks of a fit need them. An entry is one
/// observable of one reading, or one direct measurement.
struct EntryKinds {
    /// Observable of each entry, as index into `observables`; the index of a direct measurement is
    /// beyond the end of `observables`.
    std::vector<std::size_t> observable;
    std::vector<std::string> observables;  ///< names of the observables of readings
    /// Groups of entries, as indices: values of one observable measured at one condition.
    std::vector<std::vector<Eigen::Index>> conditions;
    /// Names of the calibrated parameters, in the order of the columns of
    /// WeightedResiduals::slopes().
    std::vector<std::string> parameters;
    bool replicated = false;  ///< whether any reading has replicates; there is then no runs check
};

/// Checks where and along which quantities a model fails, beyond what its calibrated parameters can
/// imitate: all checks use the projected residuals P r. The p values of all checks come from the
/// same random draws of errors, so that the probability of all checks together is exact: the share
/// of draws in which the smallest p value of any check is as small as observed.
///
/// - Lack of fit: squared length of the residuals in the space of the conditions' means.
/// - Score: the score process  S(x) = sum_{x_i <= x} (L^-1 J)_i (L^-1 (y - f))_i  of a parameter
/// returns to zero at the optimum and fluctuates like a Brownian bridge. The statistic is its
/// largest distance from zero over its standard deviation (after Hjort and Koning 2002). Entries
/// are whitened; with correlated errors each contains a part of the entries before it.
/// - Trend: component of the residuals of one observable along the measured value times the rank
/// of the covariate.
/// - Runs: negative number of changes of sign between successive readings of one observable.
/// - Neighbours: r' K r with a Gaussian kernel K over ranks of all covariates, at three lengths.
Checks check_fit(const WeightedResiduals& residuals, const EntryKinds& kinds,
                 const std::vector<Covariate>& covariates, const NullDraws& draws);

}  // namespace pendular
