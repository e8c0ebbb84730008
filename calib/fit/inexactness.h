#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/fit/measured.h"
#include "calib/model/model.h"
#include "data/reading.h"

// How inexact a model is, from the residuals that it leaves. Replicates share an error of the model
// at their condition, so that it shows as a lack of fit beyond their scatter, which no single
// effect needs to have caused.
namespace pendular {

/// Largest factor [1] on the expected discrepancy that counts as inexactness: 1 % of the stress
/// ratio for `usual_discrepancy`. Chosen: more than twice what codes with one contact law were seen
/// to differ by; a larger misfit is one to explain.
inline constexpr double largest_inexactness = 2.5;

/// Returns the logarithm of the restricted likelihood of residuals with a covariance, up to a
/// constant.
/// @param derivatives of the predictions with respect to the fitted parameters
/// Source: Patterson and Thompson, Biometrika 58 (1971) 545.
double restricted_log_likelihood(const Eigen::MatrixXd& covariance,
                                 const Eigen::VectorXd& residuals,
                                 const Eigen::MatrixXd& derivatives);

/// Most likely inexactness of a fitted model.
struct Inexactness {
    double factor = 1;  ///< on the expected discrepancy [1]
    /// chi2 [1] of the residuals at this factor, without the part that a change of the parameters
    /// can imitate.
    double chi2 = 0;
    double log_determinant = 0;  ///< ln det Sigma, the covariance at this factor
    double prior = 0;            ///< minus twice the logarithm of the prior of the factor

    /// Returns minus twice the logarithm of likelihood and prior, up to a constant: of two models
    /// of the same readings with as many parameters, the smaller is likelier.
    double criterion() const { return chi2 + log_determinant + prior; }
};

/// Returns the factor between 1 and `largest` on `Prediction::discrepancy` with the largest
/// restricted likelihood times prior, or 1 if it is not significantly larger (p > 0.05).
/// The prior is log-normal: a factor of 2 is one standard deviation. Without a discrepancy, the
/// factor is 1.
/// @param prediction at the fitted parameters, with derivatives
/// @param at_bound whether each parameter ended at a bound, and so cannot move to imitate a change;
///        empty: none did
Inexactness likely_inexactness(const Measured& measured, const Prediction& prediction,
                               const std::vector<bool>& at_bound = {},
                               double largest = largest_inexactness);

/// Returns the most likely relative error [1] of a model's shear stress (discrepancy), from the
/// residuals of its fit: the size between 0.05 % and 17 % with the largest restricted likelihood,
/// or 0 if it is not significant (p > 0.05). Errors at two conditions have the correlation
/// `discrepancy_correlation`.
/// @param conditions conditions of the readings, which come first in `measured`
/// Source: Patterson and Thompson, Biometrika 58 (1971) 545.
double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions);

}  // namespace pendular
