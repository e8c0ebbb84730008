#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/misfit/null_draws.h"
#include "analysis/misfit/weighted_residuals.h"
#include "calib/model/model.h"
#include "data/reading.h"

namespace pendular {

/// Quantity of the readings, such as the normal stress, along which residuals may have a trend.
struct Covariate {
    std::string name;
    Eigen::VectorXd values;  ///< for each measured value [SI unit]; NaN if unknown
};

/// Result of one test of whether errors alone explain the residuals (`check_fit`).
struct Check {
    enum class Kind {
        lack_of_fit,  ///< the model misses the mean of the readings at a condition
        score,        ///< a calibrated parameter changes along a covariate
        trend,        ///< residuals of an observable have a trend along a covariate
        runs,         ///< successive residuals of an observable rarely change sign
        neighbours    ///< residuals at neighbouring conditions are correlated
    };
    Kind kind = Kind::lack_of_fit;
    /// Covariate of the test; may be empty. A test of neighbours, which uses all covariates, states
    /// the length of its kernel, as in "all, length 0.3".
    std::string covariate = {};
    std::string of = {};  ///< tested parameter or observable; may be empty
    /// Statistic of `check_fit` [1]. That of a trend is positive if measured values increase with
    /// the covariate by more than predicted values; its p value is two-sided.
    double statistic = 0;
    double p = 1;
};
/// Returns the name for output, such as "lack of fit".
std::string_view to_string(Check::Kind kind);

/// All tests of the residuals of one fit.
struct Checks {
    std::vector<Check> all;  ///< for each covariate and parameter or observable
    /// p value [1] of all tests together: probability, if the model is right, that the smallest p
    /// value of all tests is at most the observed smallest.
    double p = 1;
};

/// Observable and condition of each measured value, and the calibrated parameters. A measured value
/// is one observable of one reading, or one direct measurement.
struct EntryKinds {
    /// Index into `observables` for each measured value; beyond their end for a direct measurement.
    std::vector<std::size_t> observable;
    std::vector<std::string> observables;  ///< names, such as "shear stress"
    /// Groups of measured values, by index: one observable at one condition, or one direct
    /// measurement.
    std::vector<std::vector<Eigen::Index>> conditions;
    std::vector<std::string> parameters;  ///< names, in the order of WeightedResiduals::slopes()
    bool replicated = false;              ///< whether any reading has replicates
};

/// Returns the covariates along which residuals are tested for trends: normal stress, inertial
/// number, liquid content, height, and time or run order, if the readings differ in it by more than
/// 10 %. Values are in the order of the measured values.
///
/// No covariate has the errors of the reading itself: the residual of the solid fraction V/(A H)
/// would depend on the measured height H, and on the inertial number at H, in a right model too.
/// The height and the shear rate are therefore those at the predicted solid fraction, and readings
/// at one condition have one normal stress, inertial number and height, their mean.
/// @param predicted shear stress [Pa] and solid fraction [1] of each reading in turn; further
///        entries are ignored
/// @param direct number of direct measurements, which have the value NaN
std::vector<Covariate> covariates_of(const std::vector<Reading>& readings,
                                     const Eigen::VectorXd& predicted, std::size_t direct = 0);

/// Returns the observable and the condition of each measured value: shear stress and solid fraction
/// of each reading in turn, then the direct measurements.
EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct = 0);

/// Tests at which conditions, and along which covariates, a model deviates from the readings beyond
/// what a change of the calibrated parameters can imitate. All tests use the projected residuals P
/// r of `WeightedResiduals`; their p values come from one set of random draws, so that the p value
/// of all together takes the dependence between the tests into account.
///
/// - Lack of fit: squared norm of the part of the residuals that all readings at a condition have
///   in common.
/// - Score: largest |S(x)|/|L^-1 J| over all x, with the cumulative score S(x) = sum_{x_i <= x}
///   (L^-1 J)_i (P r)_i of one parameter (after Hjort and Koning 2002), the covariate x_i of
///   measured value i and the derivatives J with respect to the parameter.
/// - Trend: projection of the residuals onto a relative error of one observable that grows in
///   proportion to the rank of the covariate.
/// - Runs: minus the number of changes of sign between successive residuals of one observable. Only
///   without replicates.
/// - Neighbours: (P r)' K (P r), with a Gaussian kernel K in the ranks of all covariates, scaled to
///   -1 to 1, between values of one observable. The statistic is large if the residuals are similar
///   at similar conditions. Made for three lengths of the kernel.
Checks check_fit(const WeightedResiduals& residuals, const EntryKinds& kinds,
                 const std::vector<Covariate>& covariates, const NullDraws& draws);

}  // namespace pendular
