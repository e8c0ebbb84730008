#include "data/recordings/findings/look_inside.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "data/quantities/statistics.h"
#include "data/recordings/findings/detectors.h"
#include "data/recordings/step_series.h"

namespace pendular {
namespace {

void add(std::vector<Remark>& to, const std::vector<Remark>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

void InsideRecordings::look_at(const std::string& file, std::vector<RecordedStep> steps,
                               const AnnularCell& cell, double least_strain) {
    std::erase_if(steps, [&](const RecordedStep& step) {
        return !step.lid_turns || strain_of(step.series, cell) < least_strain;
    });
    add(wobbles_, wobble_tests(file, steps));
    add(slips_, stick_slip_tests(file, steps));
    add(run_ins_, run_in_tests(file, steps));
    const std::vector<StepTrend> trends = step_trends(file, steps);
    trends_.insert(trends_.end(), trends.begin(), trends.end());
}

std::vector<Remark> InsideRecordings::findings(const std::vector<Reading>& from_recordings,
                                               const AnnularCell& cell) const {
    const std::vector<Remark> run_ins = significant_findings(run_ins_);
    std::vector<Remark> found = significant_findings(level_change_tests(from_recordings, cell));
    add(found, significant_findings(wobbles_));
    add(found, significant_findings(slips_));
    add(found, significant_findings(drift_tests(trends_, run_ins)));
    add(found, run_ins);
    return found;
}

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
