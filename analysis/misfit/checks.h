#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Quantity that varies between readings, such as the normal stress.
struct Covariate {
    std::string name;
    /// Value at each entry (one observable of one reading); not a number where it is unknown.
    Eigen::VectorXd values;
};

/// Test whether a model's residuals are consistent with the errors alone.
struct Check {
    enum class Kind {
        lack_of_fit,  ///< lack of fit of the conditions' means
        score,        ///< sum of scores of a calibrated parameter, cumulated along a covariate
        trend,        ///< residuals of an observable that increase or decrease with a covariate
        runs,         ///< successive readings on the same side of the model
        neighbours    ///< correlated residuals of readings at neighbouring conditions
    };
    Kind kind = Kind::lack_of_fit;
    std::string covariate = {};  ///< name of the covariate; empty: the check uses none
    std::string of = {};  ///< name of the parameter or observable checked; empty: all of them
    /// Statistic, as `check_fit` defines it for this kind of check; the trend's has a sign.
    double statistic = 0;
    double p = 1;  ///< probability of a statistic at least as large if the model is right [1]
};
/// Name of a kind of check, such as "lack of fit".
std::string_view to_string(Check::Kind kind);

/// All checks of one fit.
struct Checks {
    std::vector<Check> all;
    /// Probability that the smallest p value of all checks is at least as small as observed if the
    /// model is right [1].
    double p = 1;
};

/// Observable and condition of each entry of the readings. An entry is one observable of one
/// reading, or one direct measurement.
struct EntryKinds {
    /// Observable of each entry, as index into `observables`; the index of a direct measurement is
    /// beyond the end of `observables`.
    std::vector<std::size_t> observable;
    std::vector<std::string> observables;  ///< names of the observables of readings
    /// Groups of entries that were measured at one condition.
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
