#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/findings/harmonics.h"
#include "data/recordings/recording.h"
#include "data/recordings/step_series.h"

namespace pendular {

/// One step of constant set points in a recording: data points without spikes, and the end of the
/// transient.
struct RecordedStep {
    Step rows;                        ///< rows of the recording that form the step
    int number = 0;                   ///< number of the step in the file of the recording, from 1
    StepSeries series;                ///< data points of the step, without spikes
    std::vector<std::size_t> spikes;  ///< indices of the step's data points that were spikes
    bool lid_turns = false;           ///< whether the lid turns during the step
    /// Index of the first data point after the step's transient. The index is empty if no part of
    /// the step is steady, or if no transient was searched for.
    std::optional<std::size_t> steady;
    /// Reason why no part of the step is steady. The reason is empty if a part is steady, or if no
    /// transient was searched for.
    std::string why_unsteady = {};
    /// Periodic parts of torque, normal force and gap (`periodic_columns`), significant or not. The
    /// periodic parts are fitted to the data points after the transient or, if no part of the step
    /// is steady, to the second half of the step. The list is empty if the lid does not turn, or if
    /// the data points are too few or cover too few turns.
    std::vector<PeriodicColumn> periodic = {};
    /// Number of data points at the beginning of the steady part that are not averaged, so that the
    /// average covers whole turns of the lid and a wobble does not bias the average.
    std::size_t beyond_whole_turns = 0;
};

/// Splits a recording into steps and replaces spikes. Finds the transient and the periodic parts of
/// each step that has at least `shortest_step` rows and in which the lid turns.
/// @throws InputError if the torque has both signs within a step
std::vector<RecordedStep> recorded_steps(const Recording& recording);

/// Returns the data points of a step in which torque, force and gap should be constant: the data
/// points after the transient or, if the step never becomes steady, the second half of the step.
/// The result is empty if the lid does not turn, or if less than `shortest_step` data points are
/// left.
std::optional<StepSeries> level_part(const RecordedStep& step);

}  // namespace pendular
