#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/findings/harmonics.h"
#include "data/recordings/recording.h"
#include "data/recordings/step_series.h"

namespace pendular {

/// One step of a recording with its spikes taken out and its transient found.
struct RecordedStep {
    Step rows;                          ///< rows of the step in its recording
    int number = 0;                     ///< number of the step in its file, from 1
    StepSeries series;                  ///< samples of the step, without spikes
    std::vector<std::size_t> spikes;    ///< indices of the samples that were spikes
    bool lid_turns = false;             ///< whether the lid turns
    std::optional<std::size_t> steady;  ///< index of the first sample after the transient, if any
    std::string why_unsteady = {};      ///< reason why no part is steady; empty: a part is
    /// Periodic parts of the columns in the `level_part`; empty if it is too short for them.
    std::vector<PeriodicColumn> periodic = {};
    /// Number of samples at the beginning of the steady part to leave out of means, so that a
    /// wobble does not bias them (`whole_turns_begin`).
    std::size_t beyond_whole_turns = 0;
};

/// Splits a recording into steps, takes spikes out of them, and finds the transient and the
/// periodic parts of each step with at least `shortest_step` rows in which the lid turns.
/// @throws InputError if the torque has both signs within a step
std::vector<RecordedStep> recorded_steps(const Recording& recording);

/// Samples of a step in which its columns should be constant: the part after the transient or, if
/// the step never becomes steady, its second half. Empty if the lid does not turn, or if less than
/// `shortest_step` samples are left.
std::optional<StepSeries> level_part(const RecordedStep& step);

}  // namespace pendular
