#pragma once

#include <Eigen/Core>

#include "calib/fit/fit.h"

namespace pendular {

/// Profile likelihood of the parameter with index `which`: rise of chi2 above its minimum [1] where
/// the parameter has each of `values` [its unit] and all other parameters minimise chi2 within
/// their ranges; not a number where the readings are impossible. The covariance is that of the fit
/// `best`.
/// @throws std::logic_error where the covariance of measurement and simulation is not positive
///         definite
Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values);

}  // namespace pendular
