#pragma once

#include <Eigen/Core>

#include "calib/fit/fit.h"
#include "calib/model/response.h"

namespace pendular {

/// Returns the matrix `form` from which chi2 follows quickly if the p parameters of a fitted model
/// change by d [their units]:
///     chi2(d) = (y - f(d))' Sigma^-1 (y - f(d)) = t' form t,  t = (1, d_i, d_i d_j with i <= j),
/// with the measured values y, the second-order expansion f of the predictions about the fit, and
/// the covariance Sigma of measurement and simulation at the fit.
/// @param simulation_covariance covariance of the simulation's errors at the fit
/// @param response expansion of the predictions about the fit
/// @throws std::logic_error if Sigma is not positive definite
Eigen::MatrixXd chi2_form(const Measured& measured, const Eigen::MatrixXd& simulation_covariance,
                          const Response& response);

/// Returns the change of a fit if one reading is left out, in linear approximation. The matrix has
/// a row for each fitted reading, with the reduction of chi2 [1] and the shift of each parameter
/// [its unit]. For reading k,
///     reduction = (R e)_k' R_kk^-1 (R e)_k,   shift = -K_k R_kk^-1 (R e)_k,
///     R = Sigma^-1 (1 - J K),
/// with the residuals e, the derivatives J of the predictions with respect to the parameters, the
/// covariance Sigma of measurement and simulation, and the estimator K of the parameters (K J = 1).
/// The index k selects the two entries of the reading. Undetermined combinations of parameters do
/// not shift.
/// @param fitted number of readings that the fit uses, which come first
/// @throws std::logic_error if Sigma is not positive definite
/// Source: Cook and Weisberg, Residuals and Influence in Regression (1982), section 3.2, with
/// correlated errors.
Eigen::MatrixXd without_each(const Measured& measured, const Prediction& prediction,
                             std::size_t fitted);

}  // namespace pendular
