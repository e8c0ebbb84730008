#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures of how a diagnosis tested all candidate effects (effects that the model may
/// lack). `scan`: the predicted reduction of chi2 by each effect, beside the reduction in a refit.
/// `cosines`: how similarly the leading effects change the readings. A figure has no panels if no
/// effect can be drawn.
std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
