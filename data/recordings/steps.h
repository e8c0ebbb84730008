#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/findings/harmonics.h"
#include "data/recordings/interval_series.h"
#include "data/recordings/recording.h"
#include "data/recordings/step_series.h"

// From rows to steps of constant set points, each with the part of it that is steady.
namespace pendular {

/// Splits a recording into steps, in the order of the rows. A step begins at each new value in the
/// column interval, and at each new constant value of angular velocity or normal force: one that
/// lasts at least `shortest_step` rows and differs from the old value by more than 5 % and by more
/// than the noise. A shorter rest or other speed within a step divides it too (`breaks_of_speed`);
/// its rows stand at the beginning of the step after it.
std::vector<Step> split_steps(const Recording& recording);

/// Returns the steps of constant speed and load in an interval, as a study splits it
/// (`split_steps`); one where some speeds or loads are unknown.
std::vector<Step> steps_of(const IntervalSeries& series);

/// One step of a recording: data points without spikes, and the end of the transient.
struct RecordedStep {
    Step rows;
    int number = 0;                   ///< in the recording, from 1
    StepSeries series;                ///< spikes replaced by medians
    std::vector<std::size_t> spikes;  ///< indices of the data points that were spikes
    /// Index of the first data point at which the lid has the speed of the step (`begin_at_speed`).
    std::size_t at_speed = 0;
    bool lid_turns = false;
    /// Index of the first data point after the transient; empty if no part of the step is steady,
    /// or if no transient was searched for.
    std::optional<std::size_t> steady;
    std::string unsteady = {};  ///< column that never becomes steady; empty: torque and height
    /// Whether only the torque is steady from `steady` on, and the gap creeps (`find_creep`).
    bool gap_creeps = false;
    std::vector<PeriodicColumn> periodic = {};  ///< of `level_part`, significant or not
    /// Number of data points at the beginning of the steady part that are not averaged, so that the
    /// mean covers whole turns of the lid and a wobble does not bias it.
    std::size_t beyond_whole_turns = 0;
};

/// Returns the steps of a recording. The transient and the periodic parts are found where a step
/// has at least `shortest_step` rows and the lid turns.
/// @throws InputError if the torque has both signs within a step
std::vector<RecordedStep> recorded_steps(const Recording& recording);

/// Finds the periodic parts of a step, and what of a turn its mean leaves out.
void find_periods(RecordedStep& step);

/// Returns the data points of a step in which torque, force and gap should be constant: those after
/// the transient or, if the step never becomes steady, its second half. Empty if the lid does not
/// turn, or if less than `shortest_step` data points are left.
std::optional<StepSeries> level_part(const RecordedStep& step);

}  // namespace pendular
