#pragma once

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of up to 16 effects and errors of measurement, the largest shift of the friction by their
/// estimates' errors first. Left: shift of the fitted friction if the effect is one standard error
/// above or below its estimate, and at the smallest size that matters where this is in the range of
/// the bars, beside the standard error of the friction. Right: pull, the distance of the estimate
/// from no effect in standard errors. Without panels where nothing shifts the friction.
Figure impact_figure(const ImpactTable& table);

}  // namespace pendular
