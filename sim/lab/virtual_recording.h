#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"
#include "data/recordings/time_series.h"
#include "data/study/study.h"
#include "sim/catalogue/cell_state.h"

namespace pendular {

/// Relative standard deviation [1] of the mean torque of a recorded step about its true value, if
/// `Instrument::noise` is 1.
constexpr double torque_scatter = 0.01;
/// Relative standard deviation [1] of the mean solid fraction of a recorded step about its true
/// value, if `Instrument::noise` is 1.
constexpr double solid_fraction_scatter = 0.002;

/// True steady state of the grains in one step of a virtual recording, with the standard errors of
/// the simulated averages.
struct TrueState {
    /// Requested condition of the step: normal stress, inertial number and liquid content.
    Condition condition;
    Mean stress_ratio;    ///< true stress ratio of the grains with its standard error [1]
    Mean solid_fraction;  ///< true solid fraction of the grains with its standard error [1]
    /// Function that returns the state of the cell that the instrument shows, without noise, at a
    /// time [s] since the first recording began. The function is empty if the instrument shows the
    /// true state.
    std::function<CellState(double)> shown = {};
};

/// Noise, drift and number of recorded data points of a virtual rheometer. Standard deviations are
/// relative to the mean [1]; `noise` multiplies all of them.
struct Instrument {
    /// Factor [1] for the scatter of the mean torque and of the mean solid fraction of a step about
    /// their true values. If the factor is 1, the relative standard deviations are 1 % for the
    /// torque and 0.2 % for the solid fraction. If the factor is 0, only the statistical errors of
    /// the simulations remain.
    double noise = 1;
    int rows = 400;           ///< number of data points that the rheometer records in each step
    double step_strain = 20;  ///< shear strain of each step [1]
    /// Standard deviations of the mean torque and of the mean solid fraction of a step about their
    /// true values.
    double torque_error = torque_scatter, solid_fraction_error = solid_fraction_scatter;
    /// Share [1] of these standard deviations that is noise from row to row; the rest is equal in
    /// all rows of a step.
    double share_within = 0.25;
    double force_noise = 0.002;  ///< standard deviation of the normal force from row to row
    /// Strains [1] over which the noise from row to row loses its correlation; 0: white noise. The
    /// defaults of torque and gap are those of simulated stress ratios and solid fractions.
    double torque_correlation = 0.03, gap_correlation = 0.1, force_correlation = 0;
    /// Standard deviation of the drift from the first to the last step of a recording [1]. The
    /// drift of the torque is in units of `torque_scatter`, the drift of the solid fraction in
    /// units of `solid_fraction_scatter`.
    double drift = 0;
    /// Standard deviations of the drifts of torque, gap and normal force from the first to the last
    /// step, relative to the value itself [1]. Empty: as `drift` says, and none of the normal
    /// force.
    std::optional<double> torque_drift, gap_drift, force_drift;
};

/// Sets the time of each step of a recording and returns the duration [s] from the first to the
/// last data point of the recording. The time of a step is the mean time [s], since the first
/// recording began, of the part of the step after the start-up transient.
/// @param steps conditions of the steps; the member `time` of each condition is set
/// @param now time at which the recording begins [s], since the first recording began
double time_steps(std::vector<Condition>& steps, const GrainProperties& grains,
                  const Instrument& instrument, double now);

/// Returns the noisy recording (torque, normal force and gap over time) that a rheometer with an
/// annular cell would give for a sequence of steady states. The recording has one step for each
/// state. A step lasts a strain of `Instrument::step_strain` and begins with a start-up transient.
///
/// The mean torque of a step scatters about its true value with a relative standard deviation of
/// `Instrument::noise` times `Instrument::torque_error`. The mean gap scatters with a relative
/// standard deviation of `Instrument::noise` times `Instrument::solid_fraction_error`. Torque and
/// gap also drift from step to step (`Instrument::drift`). The variance of a step's mean is the sum
/// of three contributions. The first is the squared standard error of the simulation. The second is
/// Gaussian noise within the step, which has the share `Instrument::share_within` of the total
/// standard deviation. The third, which is the remainder, is one random factor for all torques of
/// the step and one random factor for all gaps of the step.
///
/// The noise of the normal force has a mean of 0 and no part that a step's rows share. If
/// `TrueState::shown` is set, effects on the instrument act at the time of each data point.
///
/// In the start-up transient, the torque overshoots its steady value by 15 %. The gap begins 2 %
/// below its steady value. Both deviations decay as exp(-strain/0.15).
/// @param seed seed of the instrument's random numbers
Recording record(const std::vector<TrueState>& steps, const AnnularCell& cell,
                 const GrainProperties& grains, const Instrument& instrument, std::uint64_t seed);

/// Returns a recording as the text of a CSV file that `read_recording` can read. Quantities are in
/// the usual units of rheometers, such as torque in mN m and gap in mm. Measured values have seven
/// significant digits.
std::string recording_csv(const Recording& recording);

}  // namespace pendular
