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
#include "sim/catalogue/effect.h"

namespace pendular {

/// Relative standard deviation [1] of a step's mean torque about its true value, where
/// `Instrument::noise` is 1.
constexpr double torque_scatter = 0.01;
/// Relative standard deviation [1] of a step's mean solid fraction, likewise.
constexpr double solid_fraction_scatter = 0.002;

/// True steady state of the grains in one step, with the standard errors of the simulated averages.
struct TrueState {
    Condition condition;  ///< as requested
    Mean stress_ratio;    ///< [1]
    Mean solid_fraction;  ///< [1]
    /// State of the cell that the instrument shows, without noise, at a time [s] since the first
    /// recording began; empty: the true state.
    std::function<CellState(double)> shown = {};
};

/// Noise, drift and number of recorded data points of a virtual rheometer. Standard deviations are
/// relative to the mean [1]; `noise` multiplies all of them.
struct Instrument {
    double noise = 1;         ///< 0: only the statistical errors of the simulations
    int rows = 400;           ///< data points of each step
    double step_strain = 20;  ///< shear strain of each step [1]
    double torque_error = torque_scatter, solid_fraction_error = solid_fraction_scatter;
    /// Share [1] of these standard deviations that is noise from row to row; the rest is equal in
    /// all rows of a step.
    double share_within = 0.25;
    double force_noise = 0.002;  ///< standard deviation of the normal force from row to row
    /// Strains [1] over which the noise from row to row loses its correlation; 0: white noise. The
    /// defaults of torque and gap are those of simulated stress ratios and solid fractions.
    double torque_correlation = 0.03, gap_correlation = 0.1, force_correlation = 0;
    /// Standard deviation of the drift from the first to the last step of a recording, in units of
    /// `torque_scatter` and `solid_fraction_scatter` [1].
    double drift = 0;
    /// As `drift`, relative to the value itself [1]; empty: as `drift`, and none of the normal
    /// force.
    std::optional<double> torque_drift, gap_drift, force_drift;
};

/// Sets the `time` of each step of a recording, the mean time [s] of its part after the start-up
/// transient, and returns the duration of the recording [s].
/// @param now time at which the recording begins [s], since the first recording began
double time_steps(std::vector<Condition>& steps, const GrainProperties& grains,
                  const Instrument& instrument, double now);

/// Returns the noisy recording (torque, normal force and gap over time) that a rheometer with an
/// annular cell would give for a sequence of steady states, one step for each.
///
/// The mean torque of a step scatters with a relative standard deviation of `noise` times
/// `torque_error`, the mean gap with `noise` times `solid_fraction_error`. The variance of a step's
/// mean is the sum of three contributions: the squared standard error of the simulation; Gaussian
/// noise within the step, which has the share `share_within` of the total standard deviation; and,
/// as the remainder, one random factor for all torques and one for all gaps of the step. Torque and
/// gap also drift from step to step (`drift`).
///
/// The noise of the normal force has a mean of 0 and no part that a step's rows share. If
/// `TrueState::shown` is set, effects on the instrument act at the time of each data point.
///
/// In the start-up transient, the torque overshoots its steady value by 15 %. The gap begins 2 %
/// below its steady value. Both deviations decay as exp(-strain/0.15).
Recording record(const std::vector<TrueState>& steps, const AnnularCell& cell,
                 const GrainProperties& grains, const Instrument& instrument, std::uint64_t seed);

/// Returns a recording as a CSV file that `read_recording` can read, in the usual units of
/// rheometers, such as torque in mN m and gap in mm. Measured values have seven significant digits.
std::string recording_csv(const Recording& recording);

}  // namespace pendular
