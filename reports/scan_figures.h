#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"

namespace pendular {

/// Figures of a diagnosis's scan of all effects: `scan`, the predicted reduction of chi2 by each
/// effect beside the one that a refit gave, and `cosines`, the similarity of the changes of the
/// readings by the leading effects. A figure without panels has nothing to show.
std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
