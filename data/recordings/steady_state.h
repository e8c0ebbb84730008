#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/findings/recorded_step.h"
#include "data/recordings/recording.h"
#include "data/recordings/run_clock.h"
#include "data/study/study.h"

namespace pendular {

/// Converts each step of a recording to a reading, the mean over the steady part of the step.
/// Returns the readings in the order of the steps; `Measurements::excluded` lists transients and
/// unusable steps; notes report spikes, negative torques whose sign was flipped, interpolation,
/// errors that the resolution of a column limits, and columns that were not read.
///
/// Spikes are replaced first (`take_out_spikes`). Unevenly sampled steps are interpolated linearly
/// to even spacing, since the transient and the autocorrelation are computed from evenly spaced
/// samples. The transient ends when torque and gap are both steady. A step whose steady part covers
/// less strain than `choice.least_strain` is excluded, with a description of the step
/// (`looks_like`): grains lose their initial arrangement only over strains of order 1, so the step
/// may not be in steady shear even if torque and gap are constant. If a wobble of torque, force or
/// gap with the rotation of the lid would bias the mean, the mean is taken over whole turns
/// (`whole_turns_begin`).
///
/// The covariance of a reading is that of the means within the run, with autocorrelation and with
/// the correlation of torque T and gap. It includes the error of the mean normal force F_N: a model
/// predicts the shear stress at the measured mean normal stress, so the variance of the mean of T -
/// r F_N is used, with r the ratio of mean torque to mean normal force. Fluctuations of the force
/// that the torque follows cancel out; errors of the force alone add up. (r is the slope of a
/// cohesionless material; with cohesion the slope is smaller, and this error a little too large.)
///
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// @param clock converts the mean recorded time of a steady part to the time of the reading, which
///         counts from the beginning of the study's first recording
/// @throws InputError if the torque has both signs within a step
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content, RunClock& clock,
                              const ImportSettings& choice = {});

/// Converts the steps of a recording, as `recorded_steps` returns them, to readings by the rules of
/// `reduce_recording`, with the same parameters.
Measurements reduce_steps(const std::vector<RecordedStep>& steps, const Recording& recording,
                          const AnnularCell& cell, const GrainProperties& grains,
                          double liquid_content, RunClock& clock, const ImportSettings& choice);

/// Converts each step of the first recording of a study to a reading, with the default settings of
/// import and times that begin at 0.
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// @throws InputError if the torque has both signs within a step
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content);

}  // namespace pendular
