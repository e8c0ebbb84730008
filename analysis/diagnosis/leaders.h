#pragma once

#include <vector>

#include "analysis/diagnosis/explanation.h"
#include "analysis/diagnosis/explanations.h"

namespace pendular {

/// Leading effects: candidate effects that explain most of a misfit where no refitted model fits
/// within the errors.
struct Leaders {
    Explanation model;  ///< refitted model with the leading effects alone
    /// Share of the excess chi2 - dof of the study's model that `model` removes [1].
    double explained = 0;
    double rival_share =
        0;  ///< share of repetitions in which a model without one of them leads [1]
};

/// Share of the excess chi2 - dof of a model that refitting it as `by`, with further effects,
/// removes [1]: 1 where the chi2 of `by` is at most its degrees of freedom, 0 where there is no
/// excess.
double share_explained(double chi2, int dof, const Explanation& by);

/// Finds the effects that explain most of a misfit where none of the refitted models `tried` fits;
/// empty where there are none. `chi2`, `dof`: of the model without further effects.
///
/// Repetitions of the experiment are drawn: errors e change chi2 of model m by 2 s r_m' e, with its
/// whitened residuals r_m. What all models leave shows that errors are larger than stated, by the
/// factor s^2 = chi2/dof of the best model. In each repetition the model leads that has the least
///     chi2/s^2 + ln det Sigma_m + 2 (number of its parameters),
/// Akaike's criterion for errors of that size; the determinant keeps a model whose own errors are
/// large from being preferred for them. An effect leads where it is part of the leading model in 95
/// of 100 repetitions. The leaders count where a model with them alone takes at least 90 % of the
/// excess.
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), sections 2.5
/// (QAIC) and 2.12 (bootstrap frequencies).
std::optional<Leaders> find_leaders(double chi2, int dof, const std::vector<Explanation>& tried,
                                    const Explanations& explanations);

}  // namespace pendular
