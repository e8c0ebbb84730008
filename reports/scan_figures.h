#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures of the tested effects:
/// - `scan`: predicted reduction of chi2 [1] by up to 20 effects, beside that of a refit. Without
///   panels if the readings could reveal no effect.
/// - `cosines`: absolute cosine [1] between the changes of the readings by two effects, for each
///   pair of up to ten; 1: the readings cannot tell them apart. Without panels if the readings
///   could reveal fewer than two effects.
std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
