#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/explanations.h"

namespace pendular {

/// Smallest share [1] of the excess chi2 - dof (chi2 minus degrees of freedom) of a model that a
/// refitted model must remove for the misfit to count as mostly explained.
inline constexpr double most_of_misfit = 0.9;

/// Leading effects: effects that a study's model lacks and that explain most of a misfit. Leading
/// effects are sought if no refitted model explains the whole misfit within the errors.
struct Leaders {
    /// Study's model with only the leading effects added, refitted to the readings.
    Explanation model;
    /// Share [1] of the excess chi2 - dof (chi2 minus degrees of freedom) of the study's model that
    /// `model` removes.
    double explained = 0;
    /// Share [1] of the simulated repetitions of the experiment (`find_leaders`) in which the best
    /// model lacks at least one leading effect.
    double rival_share = 0;
};

/// Returns the share [1] of the excess chi2 - dof (chi2 minus degrees of freedom) of a model that
/// the refitted model `by` removes. The share is 1 if the chi2 of `by` is at most the degrees of
/// freedom of `by`, and 0 if the model before the refit has no excess.
/// @param chi2, dof chi2 and degrees of freedom of the model before the refit
double share_explained(double chi2, int dof, const Explanation& by);

/// Finds the leading effects, which explain most of a misfit, in a diagnosis in which none of the
/// refitted models `tried` fits the readings. The result is empty if no effects explain most of the
/// misfit.
///
/// Repetitions of the experiment are drawn at random. Random errors e of the readings change chi2
/// of model m by 2 s r_m' e, with the residuals r_m of model m in units of their errors. The misfit
/// that even the best model leaves is taken as a sign that all variances are larger than stated, by
/// the factor s^2 = chi2/dof of the best model (at least 1). In each repetition, the leading model
/// has the smallest value of
///     chi2/s^2 + ln det Sigma_m + 2 (number of parameters),
/// Akaike's criterion for variances enlarged by s^2. The determinant of the covariance Sigma_m of
/// measurement and prediction prevents a model from leading merely because its predictions have
/// large errors. A leading effect is part of the leading model in at least 95 % of the repetitions.
/// The leading effects are returned only if the fit of the model with the leading effects alone
/// converged and removes at least 90 % of the excess chi2 - dof.
/// @param chi2 chi2 of the model without further effects
/// @param dof degrees of freedom of `chi2`
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), sections 2.5
/// (QAIC) and 2.12 (bootstrap frequencies).
std::optional<Leaders> find_leaders(double chi2, int dof, const std::vector<Explanation>& tried,
                                    const Explanations& explanations);

}  // namespace pendular
