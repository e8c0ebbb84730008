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
/// spikes, transients and unusable steps. The member `notes` reports spikes, negative torques whose
/// sign was changed, interpolation, standard errors that follow from the resolution of a column
/// rather than from the scatter, and columns that were not read.
///
/// Data points of steps that were recorded at uneven time intervals are first interpolated linearly
/// to even spacing, since the transient and the autocorrelation are computed from evenly spaced
/// data points. Spikes are then replaced (`take_out_spikes`). The transient ends when torque and
/// gap are both steady. A step whose steady part covers less strain than `choice.least_strain` is
/// excluded, with a description of the step (`looks_like`). Grains lose their initial arrangement
/// only over strains of order 1. A step with less strain may therefore not be in steady shear, even
/// if torque and gap are constant. If a wobble of torque, force or gap with the rotation of the lid
/// would bias the mean, the mean is taken over whole turns (`whole_turns_begin`).
///
/// The covariance of a reading is the covariance of the means within the run, including
/// autocorrelation and the correlation between torque T and gap. The covariance also includes the
/// error of the mean normal force F_N. Since a model predicts the shear stress at the measured mean
/// normal stress, the variance of the mean of T - r F_N is used, where r is the ratio of mean
/// torque to mean normal force. Fluctuations of the force that the torque follows thus cancel out,
/// and fluctuations of the force alone increase the variance. For a cohesionless
/// material, r equals the slope dT/dF_N. For a cohesive material, the slope is smaller than r, so
/// that the standard error of the shear stress is slightly overestimated.
///
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// @param clock converts the mean recorded time of a steady part to the time of the reading, which
///         is counted from the beginning of the study's first recording
/// @throws InputError if the torque has both signs within a step
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content, RunClock& clock,
                              const ImportSettings& choice = {});

/// Converts the steps of a recording to readings. The rules and all parameters other than `steps`
/// are those of `reduce_recording`.
/// @param steps steps of the recording, from `recorded_steps`
Measurements reduce_steps(const std::vector<RecordedStep>& steps, const Recording& recording,
                          const AnnularCell& cell, const GrainProperties& grains,
                          double liquid_content, RunClock& clock, const ImportSettings& choice);

/// Converts each step of a recording to a reading, with the default settings of import. Times of
/// readings are counted from time 0 of the recording, as for the first recording of a study.
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// @throws InputError if the torque has both signs within a step
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content);

}  // namespace pendular
