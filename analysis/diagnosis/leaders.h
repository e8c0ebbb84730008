#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/explanations.h"

namespace pendular {

/// Smallest share [1] by which a model refitted with further effects must reduce the excess chi2 -
/// dof (chi2 minus degrees of freedom) of a study's model, so that the effects count as explaining
/// most of the misfit.
inline constexpr double most_of_misfit = 0.9;

/// Leading effects: physical effects that a study's model lacks and that explain most of its
/// misfit. Leading effects are sought if no refitted model explains the whole misfit within the
/// errors.
struct Leaders {
    /// Study's model with only the leading effects added, refitted to the readings.
    Explanation model;
    /// Share [1] by which `model` reduces the excess chi2 - dof (chi2 minus degrees of freedom) of
    /// the study's model.
    double explained = 0;
    /// Share [1] of the simulated repetitions of the experiment (`find_leaders`) in which the best
    /// model lacks at least one leading effect.
    double rival_share = 0;
};

/// Returns the share [1] by which the refitted model `by` reduces the excess chi2 - dof (chi2 minus
/// degrees of freedom) of the model before the refit. The share is 1 if `by` leaves no excess, and
/// 0 if the model before the refit has no excess.
/// @param chi2, dof chi2 and degrees of freedom of the model before the refit
double share_explained(double chi2, int dof, const Explanation& by);

/// Finds the leading effects, which explain most of the misfit of a study's model, in a diagnosis
/// in which none of the refitted models `tried` fits the readings. Leading effects belong to the
/// best model in at least 95 % of simulated repetitions of the experiment. In a repetition with the
/// random errors e, the best model m has the smallest value of Akaike's criterion
///     (chi2 + 2 s r_m' e)/s^2 + ln det Sigma_m + 2 (number of parameters),
/// with the residuals r_m (r_m and e whitened, in units of the errors) and the covariance Sigma_m
/// of measurement and prediction. The factor s^2, the smallest chi2/dof of the models `tried` (at
/// least 1), enlarges all variances, since even the best model leaves a misfit.
///
/// The result is empty unless the fit with exactly the leading effects converged and removes at
/// least 90 % of the excess chi2 - dof of the study's model.
/// @param chi2 chi2 [1] of the study's model without further effects
/// @param dof degrees of freedom of `chi2`
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), sections 2.5
/// (QAIC) and 2.12 (bootstrap frequencies).
std::optional<Leaders> find_leaders(double chi2, int dof, const std::vector<Explanation>& tried,
                                    const Explanations& explanations);

}  // namespace pendular
