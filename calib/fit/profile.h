#pragma once

#include <Eigen/Core>
#include <utility>

#include "calib/fit/fit.h"

namespace pendular {

/// Returns both ends of the profile-likelihood interval of one parameter, in its unit. In the
/// interval, chi2 minimised over all other parameters exceeds the minimum of chi2 by at most `rise`
/// [1]. A rise of 1 gives the 68 % interval. It ends at the latest at the ends of `Fit::range`.
/// @param best fit of the model, with the covariance of the predictions
/// @param which index of the parameter
std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise = 1);
/// Returns the profile likelihood of one parameter: for each of `values` [unit of the parameter],
/// the rise of chi2 above its minimum [1] when all other parameters minimise chi2 within their
/// ranges. Infinite if no true state of the cell gives the conditions shown.
Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values);

}  // namespace pendular
