#pragma once

#include "analysis/ladder.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of the last ten ladder steps. The upper panel shows chi2/dof [1] (about 1 for a
/// correct model). The lower panel shows the relative RMS errors of shear stress and solid fraction
/// [%], for the readings and for conditions left out of the fit. A vertical line marks a step with
/// which the sequence starts anew.
Figure ladder_figure(const Ladder& ladder);

}  // namespace pendular
