#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures on the tests of physical effects that the model may lack:
/// - `scan`: predicted reduction of chi2 [1] by each of up to 20 effects, beside the reduction of
///   chi2 in a refit. The figure has no panels if the readings could reveal no effect.
/// - `cosines`: similarity of the changes of the readings by two effects, for each pair of up to
///   ten effects. The similarity is an absolute cosine [1]: 1 if the readings cannot tell the two
///   effects apart. The figure has no panels if the readings could reveal fewer than two effects.
std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
