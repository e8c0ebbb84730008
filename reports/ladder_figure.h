#pragma once

#include "analysis/ladder.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of the last ten models of a ladder. A ladder is a sequence of a study's models,
/// each with one effect more or fewer than the previous model. The upper panel shows chi2 per
/// degree of freedom of each model [1]; a correct model has about 1. The lower panel shows the
/// relative RMS errors of shear stress and solid fraction [%], for the readings and for conditions
/// left out of the fit. A vertical line marks a model with which the sequence starts anew.
Figure ladder_figure(const Ladder& ladder);

}  // namespace pendular
