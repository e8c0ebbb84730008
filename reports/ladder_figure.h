#pragma once

#include "analysis/ladder.h"
#include "reports/figure.h"

namespace pendular {

/// How the error of a study's model went down with each effect: above, chi2 over its degrees of
/// freedom, beside 1 where model and errors are right; below, the RMS error of both observables,
/// fitted and for conditions left out of the fit. The latest ladder steps where they are many. A
/// line stands where the ladder begins anew.
Figure ladder_figure(const Ladder& ladder);

}  // namespace pendular
