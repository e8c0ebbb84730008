#pragma once

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"

namespace pendular {

/// Figure of up to 16 effects and errors of measurement that shift the fitted friction. Left panel:
/// bars for the shift of the friction [10^-3] if the effect is one standard error above or below
/// its estimate, and a symbol for the shift at the effect's smallest size of interest, unless it is
/// far beyond the bars; the band is the standard error of the friction. Right panel: the pull, the
/// difference between the estimate and no effect divided by the standard error of the estimate [1].
/// Rows are sorted by the length of the bars, the longest at the top. Has no panels if no effect or
/// error has an estimate with a standard error.
Figure impact_figure(const ImpactTable& table);

}  // namespace pendular
