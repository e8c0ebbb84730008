#pragma once

#include "analysis/ladder.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of a ladder, the sequence of a study's models in which each model has one
/// effect more or fewer than the previous model. A ladder of more than ten models is cut to the
/// last ten models. The upper panel shows chi2 per degree of freedom of each model [1], beside the
/// value 1 that is expected if the model and the standard errors are right. The lower panel shows
/// the relative RMS errors of shear stress and solid fraction [%], first for the readings, second
/// in cross-validation, in which each condition is predicted by a fit to the other conditions. A
/// vertical line marks a model that does not follow from the previous model by adding or dropping
/// one effect.
Figure ladder_figure(const Ladder& ladder);

}  // namespace pendular
