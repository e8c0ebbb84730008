#pragma once

#include "analysis/ladder.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of a ladder, the sequence of a study's models that differ by one effect each; a long
/// ladder is cut to its last ten models. Upper panel: chi2 per degree of freedom of each model [1],
/// beside the value 1 that is expected if model and standard errors are right. Lower panel: RMS
/// relative errors of shear stress and solid fraction [%], for the readings and in cross-validation
/// (each condition predicted by a fit to the other conditions). A vertical line marks a model that
/// does not follow from the one before by adding or dropping one effect.
Figure ladder_figure(const Ladder& ladder);

}  // namespace pendular
