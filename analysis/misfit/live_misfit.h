#pragma once

#include <Eigen/Core>

#include "calib/fit/fit.h"
#include "calib/model/response.h"

namespace pendular {

/// chi2 of a fitted model as its p parameters are moved from the fit by d [their units], with the
/// measured values y and the second-order expansion f of the predictions:
///     chi2(d) = (y - f(d))' Sigma^-1 (y - f(d)) = t' form t,  t = (1, d_i, d_i d_j with i <= j),
/// with the covariance Sigma of measurement and simulation at the fit.
/// @return `form`, symmetric, with 1 + p + p (p + 1)/2 rows for p parameters
/// @throws std::logic_error where Sigma is not positive definite
Eigen::MatrixXd chi2_form(const Measured& measured, const Eigen::MatrixXd& simulation_covariance,
                          const Response& response);

/// Change of a fit when one reading is left out, in linear approximation: a row for each reading
/// with the fall of chi2 [1], then the shift of each parameter [its unit]. With e the residuals,
/// J the derivatives, K the estimator (K J = 1), R = Sigma^-1 (1 - J K), and k the two entries of
/// a reading (columns of K):
///     fall = (R e)_k' R_kk^-1 (R e)_k,   shift = -K_k R_kk^-1 (R e)_k.
/// Combinations of parameters that the readings do not determine do not shift.
/// Source: Cook and Weisberg, Residuals and Influence in Regression (1982), section 3.2, with
/// correlated errors.
/// @param fitted number of readings that the fit uses, the first; a row each
/// @throws std::logic_error where Sigma is not positive definite
Eigen::MatrixXd without_each(const Measured& measured, const Prediction& prediction,
                             std::size_t fitted);

}  // namespace pendular
