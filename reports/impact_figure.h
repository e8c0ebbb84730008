#pragma once

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of up to 16 effects and errors of measurement that shift the fitted friction. Left: shift
/// of the friction if the effect is one standard error above or below its estimate, and at its
/// smallest size of interest where this is in the range of the bars, beside the standard error of
/// the friction. Right: pull, the distance of the estimate from no effect in standard errors. The
/// first rows have the largest shift for one standard error. Without panels where nothing shifts
/// the friction.
Figure impact_figure(const ImpactTable& table);

}  // namespace pendular
