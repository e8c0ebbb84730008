#pragma once

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of up to 16 physical effects and errors of measurement that shift the fitted
/// friction coefficient, the largest shift at the top. The figure has no panels if no effect or
/// error has an estimate with a standard error.
/// - Left panel: bars show the shift of the friction coefficient [10^-3] if the effect is one
///   standard error larger or smaller than estimated. A symbol shows the shift by the effect at its
///   smallest size of interest, unless the symbol would lie outside the axes. The band is the
///   standard error of the friction coefficient.
/// - Right panel: the pull [1], which is the estimated size minus the size without the effect,
///   divided by the standard error of the estimate.
Figure impact_figure(const ImpactTable& table);

}  // namespace pendular
