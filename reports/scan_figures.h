#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures on the tests of candidate effects (effects that the model may lack) in a
/// diagnosis. `scan` shows the predicted reduction of chi2 by each of up to 20 effects, beside the
/// reduction of chi2 in a refit. `cosines` shows how similarly two effects change the readings, for
/// each pair of up to ten effects with the largest reductions. The similarity is an absolute cosine
/// [1]: 1 if the readings cannot tell the two effects apart. `scan` has no panels if the readings
/// could reveal no effect. `cosines` has no panels if the readings could reveal fewer than two
/// effects.
std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
