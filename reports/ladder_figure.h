#pragma once

#include "analysis/ladder.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of a ladder, the sequence of a study's models that differ by one effect each; a long
/// ladder is cut to its last ten models. Above: chi2 per degree of freedom of each model, beside
/// the value 1 of a right model with right errors. Below: RMS relative errors of shear stress and
/// solid fraction [%], for the readings and in cross-validation (each condition predicted by a fit
/// to the others). Vertical lines mark where the ladder starts anew.
Figure ladder_figure(const Ladder& ladder);

}  // namespace pendular
