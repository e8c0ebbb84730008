#pragma once

#include <Eigen/Core>

#include "calib/fit/fit.h"
#include "calib/model/response.h"

namespace pendular {

/// Returns the symmetric matrix F that gives chi2 [1] at once if the p parameters of a fit change
/// by d [their units], for sliders that the user moves:
///     chi2(d) = (y - f(d))' Sigma^-1 (y - f(d)) = t' F t,  t = (1, d_i, d_i d_j with i <= j),
/// with the measured values y, the expansion f of the predictions to second order, and the
/// covariance Sigma of measurement and simulation. F has 1 + p + p (p + 1)/2 rows and columns.
/// @param simulation_covariance covariance of the simulation's errors at the fitted parameters
/// @throws std::logic_error if Sigma is not positive definite
Eigen::MatrixXd chi2_form(const Measured& measured, const Eigen::MatrixXd& simulation_covariance,
                          const Response& response);

/// Returns the change of a fit if one reading is left out, in linear approximation: a row for each
/// fitted reading with the reduction of chi2 [1] and the shift of each parameter [its unit]. For
/// reading k,
///     reduction = (R e)_k' R_kk^-1 (R e)_k,   shift = -K_k R_kk^-1 (R e)_k,
///     R = Sigma^-1 (1 - J K),
/// with the residuals e, the derivatives J of the predictions, and the estimator K of the
/// parameters (K J = 1). The index k selects the two values of the reading. Combinations of
/// parameters that the readings do not determine do not shift.
/// @param fitted number of fitted readings, which come first in `measured`
/// @throws std::logic_error if Sigma is not positive definite
/// Source: Cook and Weisberg, Residuals and Influence in Regression (1982), section 3.2, with
/// correlated errors.
Eigen::MatrixXd without_each(const Measured& measured, const Prediction& prediction,
                             std::size_t fitted);

}  // namespace pendular
