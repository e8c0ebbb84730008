#include "data/recordings/findings/recorded_step.h"

#include "data/recordings/step_series.h"
#include "data/recordings/time_series.h"

namespace pendular {

void find_periods(RecordedStep& step) {
    const auto part = level_part(step);
    if (!part) return;
    step.periodic = periodic_columns(*part);
    if (step.steady) step.beyond_whole_turns = whole_turns_begin(*part, step.periodic);
}

std::vector<RecordedStep> recorded_steps(const Recording& recording) {
    std::vector<RecordedStep> result;
    for (const Step& rows : split_steps(recording)) {
        RecordedStep step{.rows = rows,
                          .number = static_cast<int>(result.size()) + 1,
                          .series = step_series(recording, rows)};
        step.spikes = take_out_spikes(step.series);
        step.lid_turns = turns(mean_of_correlated(step.series.angular_velocity));
        if (step.series.size() >= shortest_step && step.lid_turns)
            step.steady = end_of_transient(step.series, step.unsteady);
        find_periods(step);
        result.push_back(std::move(step));
    }
    return result;
}

std::optional<StepSeries> level_part(const RecordedStep& step) {
    if (!step.lid_turns) return std::nullopt;
    const std::size_t begin = step.steady.value_or(step.series.size() / 2);
    if (step.series.size() - begin < shortest_step) return std::nullopt;
    return step.series.from(begin);
}

}  // namespace pendular
