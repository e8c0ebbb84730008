#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "calib/fit/fitted_model.h"

// Ranking of models that were fitted to the same readings, by Akaike's criterion,
//     chi2/s^2 + ln det Sigma + 2 k,
// with k parameters, the covariance Sigma of the errors of measurement and prediction, and the
// factor s^2 by which all variances are larger than stated. The determinant counts where Sigma
// differs between models: a model would otherwise win because its own errors are large. The
// smallest criterion is best; constants that all models share are left out. The diagnosis counts
// all terms; where rivals of one effect are kept or models are chosen for simulations, the
// determinant is left out, since these only spend a measurement or a run, and the former also leave
// out s^2, since the study's model fits there.
//
// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), sections 2.5 and
// 2.6: models within 2 of the best have substantial support, at 4 to 7 considerably less, beyond 10
// essentially none.
namespace pendular {

/// Difference of the criterion from which a model is clearly better: essentially no support is left
/// for the other.
inline constexpr double clearly_better = 10;
/// Difference to the best model from which the readings rule a model out: the end of the range of
/// considerably less support. Above 2, since to keep a rival costs less than to miss it.
inline constexpr double ruled_out = 7;
/// Difference to the best model up to which simulations are spent on a model. Below `ruled_out`,
/// since a round of simulations serves three models, and a simpler one, at most.
inline constexpr double worth_simulating = 6;

/// Returns Akaike's criterion [1].
inline double akaike(const FittedModel& model, double variance_factor = 1,
                     double log_determinant = 0) {
    return model.fit.chi2 / variance_factor + log_determinant +
           2.0 * static_cast<double>(model.fit.parameters.size());
}

/// Returns the factor s^2 [1]: the smallest chi2/dof of the refitted models, at least 1; 1 without
/// any. A misfit that even the best model leaves is taken as a sign of larger errors, so that
/// differences of chi2 are not overrated.
inline double factor_on_variance(const std::vector<FittedModel>& tried) {
    double least = INFINITY;
    for (const FittedModel& each : tried) {
        least = std::min(least, each.fit.chi2 / std::max(1, each.fit.dof));
    }
    return std::isfinite(least) ? std::max(1.0, least) : 1;
}

}  // namespace pendular
