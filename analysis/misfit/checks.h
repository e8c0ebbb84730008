#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"

namespace pendular {

/// Covariate: quantity that varies between readings, such as the normal stress, along which
/// residuals are checked for trends.
struct Covariate {
    std::string name;
    /// Value of the quantity, in SI units, for each measured value (one observable of one reading,
    /// or one direct measurement). The value is not a number (NaN) if it is unknown.
    Eigen::VectorXd values;
};

/// Result of one statistical test of whether the errors of readings and predictions alone explain
/// the residuals of a fitted model.
struct Check {
    enum class Kind {
        lack_of_fit,  ///< test whether the model misses the mean of the readings at a condition
        /// Test whether a calibrated parameter changes along a covariate (quantity such as the
        /// normal stress), by the cumulated sum of the parameter's scores (derivatives of -chi2/2)
        /// along the covariate.
        score,
        trend,      ///< test for a trend of an observable's residuals along a covariate
        runs,       ///< test whether successive residuals of an observable rarely change sign
        neighbours  ///< test for correlation between the residuals of neighbouring conditions
    };
    /// Kind of the statistical test.
    Kind kind = Kind::lack_of_fit;
    /// Name of the covariate (quantity such as the normal stress) along which the test was made.
    /// The name is empty if the test has no covariate. For a test of neighbouring conditions, which
    /// uses all covariates, the name states the correlation length, in ranks of the covariates that
    /// are scaled to -1 to 1, such as "all, length 0.3".
    std::string covariate = {};
    /// Name of the calibrated parameter or of the observable that is tested. The name is empty if
    /// the test applies to all observables.
    std::string of = {};
    /// Test statistic [1], which `check_fit` defines for each kind of test. The statistic of a
    /// trend is positive if measured values increase with the covariate by more than predicted
    /// values, and negative if they increase by less.
    double statistic = 0;
    /// p value [1] of the test: probability, if the model is right, of a statistic at least as
    /// large as `statistic`. For a trend, the absolute values of both statistics are compared.
    double p = 1;
};
/// Returns the name of a kind of statistical test for output, such as "lack of fit".
std::string_view to_string(Check::Kind kind);

/// Results of all statistical tests of the residuals of one fit, with one p value of all tests
/// together.
struct Checks {
    /// Results of all statistical tests of the fit, with one result for each kind of test,
    /// covariate (quantity such as the normal stress), and parameter or observable.
    std::vector<Check> all;
    /// p value [1] of all statistical tests together: probability, if the model is right, that the
    /// smallest p value of all tests is at most the observed smallest p value.
    double p = 1;
};

/// Observable and condition of each measured value, and names of the calibrated parameters, for the
/// statistical tests of a fit. A measured value is one observable of one reading, or one direct
/// measurement of an effect's parameter.
struct EntryKinds {
    /// Observable of each measured value, as an index into `observables`. A direct measurement of
    /// an effect's parameter has an index beyond the end of `observables`.
    std::vector<std::size_t> observable;
    /// Names of the observables of the readings, such as "shear stress".
    std::vector<std::string> observables;
    /// Groups of measured values: for each group, the indices of the values. A group contains the
    /// values of one observable at one condition, or a single direct measurement of an effect's
    /// parameter.
    std::vector<std::vector<Eigen::Index>> conditions;
    /// Names of the calibrated parameters, in the order of the columns of
    /// WeightedResiduals::slopes().
    std::vector<std::string> parameters;
    /// Whether any reading has replicates (readings at the same condition). If so, `check_fit`
    /// omits the test for few changes of sign between successive residuals.
    bool replicated = false;
};

/// Tests at which conditions, and along which covariates (quantities such as the normal stress), a
/// model deviates from the readings beyond what a change of the calibrated parameters can imitate.
/// All tests use the projected whitened residuals P r of `WeightedResiduals`. The p values come
/// from one set of random draws of errors. The p value of all tests together is the share of draws
/// in which the smallest p value of all tests is at most the smallest p value for the readings.
///
/// - Lack of fit: squared norm of the part of the residuals that all readings at a condition have
///   in common (deviation of their mean from the model).
/// - Score: largest |S(x)|/|L^-1 J| over all x, with the cumulative score S(x) = sum_{x_i <= x}
///   (L^-1 J)_i (P r)_i of one parameter (after Hjort and Koning 2002). x_i is the covariate of
///   measured value i. J contains the derivatives of the predictions with respect to the parameter.
///   L is the Cholesky factor of the covariance of measurement and simulation.
/// - Trend: projection of the residuals onto a relative error of one observable that grows in
///   proportion to the rank of the covariate.
/// - Runs: minus the number of changes of sign between successive residuals of one observable. The
///   test is made only without replicates.
/// - Neighbours: (P r)' K (P r), with a Gaussian kernel K in the ranks of all covariates, scaled to
///   -1 to 1. The statistic is large if the residuals of one observable are similar at similar
///   conditions. The test is made for three correlation lengths (widths of the kernel).
Checks check_fit(const WeightedResiduals& residuals, const EntryKinds& kinds,
                 const std::vector<Covariate>& covariates, const NullDraws& draws);

}  // namespace pendular
