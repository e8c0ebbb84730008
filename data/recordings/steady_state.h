#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/findings/recorded_step.h"
#include "data/recordings/recording.h"
#include "data/recordings/run_clock.h"
#include "data/study/study.h"

namespace pendular {

/// Converts each step of a recording to a reading, the mean over the steady part of the step.
/// Returns the readings in the order of the steps. The member `excluded` of the result lists
/// spikes, transients and unusable steps, such as steps whose steady part covers less strain than
/// `choice.least_strain`. The member `notes` lists further treatment, such as interpolation. If a
/// wobble with the rotation of the lid would bias the mean, the mean is taken over whole turns
/// (`whole_turns_begin`).
///
/// The covariance of a reading includes the autocorrelation within the run, the correlation between
/// torque T and gap, and the error of the mean normal force F_N. The variance of T is the variance
/// of the mean of T - r F_N, with the ratio r of mean torque to mean normal force. For a cohesive
/// material, r exceeds the slope dT/dF_N, and the standard error of the shear stress is slightly
/// overestimated.
///
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// @param clock converts the mean recorded time of a steady part to the time of the reading, which
///         is counted from the beginning of the study's first recording
/// @throws InputError if the torque has both signs within a step
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content, RunClock& clock,
                              const ImportSettings& choice = {});

/// Converts the steps of a recording to readings (mean over the steady part of each step), with the
/// rules and the parameters of `reduce_recording`.
/// @param steps steps of the recording, from `recorded_steps`
Measurements reduce_steps(const std::vector<RecordedStep>& steps, const Recording& recording,
                          const AnnularCell& cell, const GrainProperties& grains,
                          double liquid_content, RunClock& clock, const ImportSettings& choice);

/// Converts each step of a recording to a reading, the mean over the steady part of the step, with
/// the default settings of import. Times of readings are counted from time 0 of the recording, as
/// for the first recording of a study.
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// @throws InputError if the torque has both signs within a step
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content);

}  // namespace pendular
