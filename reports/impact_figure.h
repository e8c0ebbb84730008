#pragma once

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"

namespace pendular {

/// Returns a figure of up to 16 effects and errors of measurement that shift the fitted friction
/// coefficient. The bars in the left panel show by how much the friction coefficient shifts [10^-3]
/// if the size of the effect is one standard error above or below the estimate, instead of at the
/// estimate. A symbol in the left panel shows the shift at the smallest size of interest of the
/// effect, unless the symbol would lie outside the axes. The band is the standard error of the
/// friction coefficient. The right panel shows the pull [1]: the difference between the estimated
/// size and no effect, divided by the standard error of the estimate. Rows are sorted by the length
/// of the bars, the row with the longest bars at the top. The figure has no panels if no effect or
/// error has an estimate with a standard error.
Figure impact_figure(const ImpactTable& table);

}  // namespace pendular
