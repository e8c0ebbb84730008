#pragma once

#include <vector>

#include "analysis/diagnosis/evidence.h"
#include "analysis/diagnosis/explanations.h"

namespace pendular {

/// Smallest share [1] of the excess chi2 - dof of a study's model that further effects must remove
/// to count as explaining most of the misfit. Chosen: what remains is then a small part, whatever
/// its cause.
inline constexpr double most_of_misfit = 0.9;

/// Effects that explain most of a misfit that no refitted model explains within the errors.
struct Leaders {
    FittedModel model;     ///< study's model with only the leading effects added
    double explained = 0;  ///< share of the excess chi2 - dof that `model` removes [1]
    /// Share [1] of the simulated repetitions of the experiment in which the best model lacks at
    /// least one leading effect.
    double rival_share = 0;
};

/// Returns the share [1] of the excess chi2 - dof of a model that the refitted model `by` removes:
/// 1 if `by` leaves no excess, 0 if there was none.
double share_explained(double excess, const FittedModel& by);

/// Finds the leading effects if none of the refitted models `tried` fits the readings: the effects
/// that belong to the best model in at least 95 % of simulated repetitions of the experiment. In a
/// repetition with the errors e, the best model m has the smallest value of Akaike's criterion
///     (chi2 + 2 s r_m' e)/s^2 + ln det Sigma_m + 2 (number of parameters),
/// with the residuals r_m (r_m and e whitened) and the covariance Sigma_m of measurement and
/// prediction. The factor s^2 (`factor_on_variance`) enlarges all variances, since even the best
/// model leaves a misfit. Empty unless the fit with exactly the leading effects converged and
/// removes `most_of_misfit`.
/// @param excess chi2 - dof of the study's model without further effects
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), sections 2.5
/// (QAIC) and 2.12 (bootstrap frequencies).
std::optional<Leaders> find_leaders(double excess, const std::vector<FittedModel>& tried,
                                    const Explanations& explanations);

}  // namespace pendular
