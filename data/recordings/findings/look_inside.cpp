#include "data/recordings/findings/look_inside.h"

#include "data/recordings/findings/false_alarms.h"
#include "data/recordings/findings/level_change.h"
#include "data/recordings/findings/stick_slip.h"
#include "data/recordings/findings/wobble.h"
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

}  // namespace pendular
