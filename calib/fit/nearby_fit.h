#pragma once

#include <Eigen/Core>

#include "calib/fit/fit.h"

namespace pendular {

/// Fits a model as two calls of `fit` do, the second with the simulation errors at the result of
/// the first, with fewer evaluations of the model, for a start from which Gauss-Newton steps lead
/// to the minimum. Each step leads to the minimum of chi2 of the model's tangent within the bounds
/// of the parameters (found by Ceres), or to a half, a quarter, ... of the way there as long as
/// chi2 would not fall.
/// @param simulation covariance of the simulation errors in the first call, such as that of a model
///        with fewer effects; null: that of the model at `start`
/// @throws std::logic_error where the covariance of measurement and simulation is not positive
///         definite
/// @throws std::domain_error where the readings are impossible at `start`
Fit nearby_fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
               const Eigen::MatrixXd* simulation = nullptr);

}  // namespace pendular
