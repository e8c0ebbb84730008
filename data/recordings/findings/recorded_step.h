#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/findings/harmonics.h"
#include "data/recordings/recording.h"
#include "data/recordings/step_series.h"

namespace pendular {

/// One step of constant set points in a recording: its samples without spikes, and where its
/// transient ends.
struct RecordedStep {
    Step rows;                        ///< rows of the recording that form the step
    int number = 0;                   ///< number of the step in its file, from 1
    StepSeries series;                ///< samples of the step, without spikes
    std::vector<std::size_t> spikes;  ///< indices of the step's samples that were spikes
    bool lid_turns = false;           ///< true if the lid turns during the step
    /// Index of the first sample after the step's transient; empty if no part of the step is
    /// steady.
    std::optional<std::size_t> steady;
    /// Reason why no part of the step is steady; empty if a part is steady.
    std::string why_unsteady = {};
    /// Periodic parts of the step's columns after the transient; empty if this part is too short.
    std::vector<PeriodicColumn> periodic = {};
    /// Number of samples at the beginning of the steady part that are not averaged, so that the
    /// average covers whole turns of the lid and a wobble does not bias it.
    std::size_t beyond_whole_turns = 0;
};

/// Splits a recording into steps, replaces spikes, and finds the transient and the periodic parts
/// of each step with at least `shortest_step` rows in which the lid turns.
/// @throws InputError if the torque has both signs within a step
std::vector<RecordedStep> recorded_steps(const Recording& recording);

/// Returns the samples of a step in which torque, force and gap should be constant: the samples
/// after the transient or, if the step never becomes steady, its second half. Empty if the lid does
/// not turn, or if less than `shortest_step` samples are left.
std::optional<StepSeries> level_part(const RecordedStep& step);

}  // namespace pendular
