#include "data/recordings/findings/false_alarms.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "data/quantities/distributions.h"

namespace pendular {

std::vector<Remark> significant_findings(std::vector<Remark> tested) {
    std::vector<double> p;
    for (const Remark& each : tested)
        p.push_back(each.p);
    std::ranges::sort(p);
    double limit = -1;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const double allowed =
            finding_significance * static_cast<double>(k + 1) / static_cast<double>(p.size());
        if (p[k] <= allowed) limit = p[k];
    }
    std::erase_if(tested, [&](const Remark& each) { return each.p > limit; });
    return tested;
}

double two_sided_p(double z, double freedom) {
    if (std::isnan(z)) return 1;
    if (std::isinf(z)) return 0;
    return 2 * students_t_tail(std::abs(z), std::max(freedom, 1.0));
}

}  // namespace pendular
