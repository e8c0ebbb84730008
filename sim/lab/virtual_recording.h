#pragma once

#include <cstdint>
#include <functional>
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

/// Noise, drift and number of recorded data points of a virtual rheometer.
struct Instrument {
    /// Factor [1] for the scatter of the mean torque and of the mean solid fraction of a step about
    /// their true values. If the factor is 1, the relative standard deviations are 1 % for the
    /// torque and 0.2 % for the solid fraction. If the factor is 0, only the statistical errors of
    /// the simulations remain.
    double noise = 1;
    int rows = 400;  ///< number of data points that the rheometer records in each step
    /// Standard deviation of the drift from the first to the last step of a recording [1]. The
    /// drift of the torque is in units of `torque_scatter`, the drift of the solid fraction in
    /// units of `solid_fraction_scatter`.
    double drift = 0;
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
/// state. A step lasts a strain of 20 and begins with a start-up transient.
///
/// The mean torque of a step scatters about its true value with a relative standard deviation of
/// `Instrument::noise` times `torque_scatter`. The mean gap scatters with a relative standard
/// deviation of `Instrument::noise` times `solid_fraction_scatter`. Torque and gap also drift from
/// step to step (`Instrument::drift`). The variance of a step's mean is the sum of three
/// contributions. The first is the squared standard error of the simulation. The second is Gaussian
/// noise within the step, which has a quarter of the total standard deviation. The third, which is
/// the remainder, is one random factor for all torques of the step and one random factor for all
/// gaps of the step.
///
/// The noise within the step is correlated over a strain of 0.03 for the torque and of 0.1 for the
/// gap. The normal force has white noise with a relative standard deviation of `Instrument::noise`
/// times 0.2 %. If `TrueState::shown` is set, effects on the instrument act at the time of each
/// data point.
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
