#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/recordings/run_clock.h"
#include "data/study/study.h"

namespace pendular {

/// Turns each step of a recording into a reading of its steady part; beads of `liquid_content` [1].
///
/// The transient, up to where torque and gap are both steady, and steps that cannot be used are
/// listed in `excluded`. A wholly negative torque is flipped and noted; so are
/// columns that were not read, and uneven sampling: such a step is first
/// interpolated linearly to even spacing, since both the transient and the autocorrelation are
/// those of evenly spaced samples.
///
/// The covariance is that of the means within the run, autocorrelation respected, correlation of
/// torque and gap included. The error of the mean normal force is in it: the shear stress is
/// compared with a model at the mean normal stress shown, so what counts is the scatter of
/// T - (T/F) F_N, not of T alone. Forces that fluctuate and take the torque along cancel, forces
/// that only read wrong add up. (T/F is the slope of a cohesionless material; with cohesion it is
/// smaller, and this error a little too large.)
///
/// Single rows that jump far off their neighbours and back (`spikes`) are left out first.
///
/// A step whose steady part covers less than the least strain of `choice` is no steady shear, even
/// if it looks constant: grains lose their initial arrangement only over strains of order 1. It is
/// excluded, with a description of what it looks like instead.
///
/// The time of a reading is the mean time of the steady part, on the clock that continues from the
/// recordings before this one.
/// @throws InputError where the torque has both signs within a step
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content, RunClock& clock,
                              const ImportSettings& choice = {});

/// Reduces the first recording of a study.
Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content);

}  // namespace pendular
