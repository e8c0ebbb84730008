#pragma once

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of up to 16 effects and errors of measurement that shift the fitted friction
/// coefficient, the largest shift at the top. Without panels if none has an estimate with an error.
/// - Left: bars show the shift [10^-3] if the effect is one standard error larger or smaller than
///   estimated. A symbol shows the shift by the smallest size of interest, unless it would lie
///   outside the axes. The band is the standard error of the friction coefficient.
/// - Right: the pull [1], (estimate - value without the effect)/(standard error).
Figure impact_figure(const ImpactTable& table);

}  // namespace pendular
