#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of the test of all candidate effects in a diagnosis: `scan`, the predicted
/// reduction of chi2 by each effect beside the reduction in a refit, and `cosines`, how similarly
/// the leading effects change the readings. A figure without panels has nothing to show.
std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
