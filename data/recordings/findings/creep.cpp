#include "data/recordings/findings/creep.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "data/recordings/findings/detectors.h"
#include "data/recordings/findings/drift.h"
#include "data/recordings/step_series.h"

namespace pendular {
namespace {

/// Changes of a gap over their standard error [1] from which one step creeps whatever the others
/// do, and from which two steps of one recording do.
constexpr double clear_creep = 4, clear_in_two = 2;

/// Mean change of the gap within a step of a recording [1], if it is significant; 0 otherwise.
double common_drift(const std::string& file, const std::vector<RecordedStep>& steps) {
    for (const Remark& test : drift_tests(step_trends(file, steps), {}))
        if (test.quantity == "height" && test.p < finding_significance) return test.relative;
    return 0;
}

/// Whether the gap of a step creeps, given the creep of all steps of the recording whose gap is not
/// steady.
bool is_creep(const Creep& creep, const std::vector<std::optional<Creep>>& all, double drift) {
    const double size = std::abs(creep.change) / creep.error;
    const auto alike = std::ranges::count_if(all, [&](const std::optional<Creep>& other) {
        return other && other->change * creep.change > 0 &&
               std::abs(other->change) > clear_in_two * other->error;
    });
    return creep.change * drift > 0 || size > clear_creep || (size > clear_in_two && alike >= 2);
}

}  // namespace

void find_creep(const std::string& file, std::vector<RecordedStep>& steps) {
    std::vector<std::optional<Creep>> found(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k)
        if (steps[k].unsteady == "height") found[k] = creep_of(steps[k].series);
    if (std::ranges::none_of(found, &std::optional<Creep>::has_value)) return;
    const double drift = common_drift(file, steps);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (!found[k] || !is_creep(*found[k], found, drift)) continue;
        steps[k].steady = found[k]->begin;
        steps[k].gap_creeps = true;
        find_periods(steps[k]);
    }
}

}  // namespace pendular
