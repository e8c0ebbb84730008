#include "analysis/diagnosis/ranking.h"

#include <algorithm>
#include <cmath>

namespace pendular {

double factor_on_variance(const std::vector<Explanation>& tried) {
    double least = INFINITY;
    for (const Explanation& each : tried) {
        least = std::min(least, each.chi2 / std::max(1, each.fit.dof));
    }
    return std::isfinite(least) ? std::max(1.0, least) : 1;
}

}  // namespace pendular
