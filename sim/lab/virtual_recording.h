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

/// Relative standard deviations [1], from the true values, of the mean torque (1 %) and of the mean
/// solid fraction (0.2 %) of a recorded step, if `Instrument::noise` is 1.
constexpr double torque_scatter = 0.01;
constexpr double solid_fraction_scatter = 0.002;

/// True steady state of the grains in one step of a virtual recording, with the standard errors of
/// the simulation from which it comes.
struct TrueState {
    Condition condition;  ///< requested condition of the step
    Mean stress_ratio;    ///< true stress ratio of the grains with its standard error [1]
    Mean solid_fraction;  ///< true solid fraction of the grains with its standard error [1]
    /// Function of the time [s] since the first recording began: the state of the cell that the
    /// instrument shows at that time, without noise. Empty if the instrument shows the true state.
    std::function<CellState(double)> shown = {};
};

/// Noise, drift and number of recorded rows of a virtual rheometer.
struct Instrument {
    /// Factor [1] for the scatter of the mean torque and mean solid fraction of a step about their
    /// true values. 1: standard deviations of 1 % and 0.2 %; 0: only the statistical errors of the
    /// simulations.
    double noise = 1;
    int rows = 400;  ///< number of rows that the rheometer records in each step
    /// Standard deviation of the drift of torque and solid fraction from the first to the last step
    /// of a recording, in units of `torque_scatter` and `solid_fraction_scatter` [1].
    double drift = 0;
};

/// Sets the time of each step of a recording: the mean time [s] of the part of the step after the
/// start-up transient. Returns the duration of the recording [s].
/// @param steps conditions of the steps; their member `time` is set
/// @param now time at which the recording begins [s]
double time_steps(std::vector<Condition>& steps, const GrainProperties& grains,
                  const Instrument& instrument, double now);

/// Returns the noisy recording that an annular cell would give for a sequence of steady states,
/// with one step for each state. Each step begins with a start-up transient.
///
/// The mean torque and gap of a step scatter about their values in an infinitely long step with a
/// relative standard deviation of `noise` times `torque_scatter` or `solid_fraction_scatter`. Its
/// variance is the sum of three parts: the squared standard error of the simulation, the variance
/// from noise within the step (with a quarter of the standard deviation), and the remainder, which
/// is applied as a random factor of the step. The noise of torque and gap within the step is
/// Gaussian and correlated over strains of 0.03 and 0.1, as in simulated samples. The normal force
/// has white noise of `noise` times 0.2 % about its set point, so that the mean force of a step of
/// 400 rows is off by 0.01 %.
///
/// If the faults of the instrument change with time (`TrueState::shown`), they are applied at the
/// time of each row.
///
/// A step lasts a strain of 20. The torque first rises over a strain of about 0.02 and overshoots
/// its steady value by up to 30 %; the gap begins 2 % below its steady value. Both deviations decay
/// as exp(-strain/0.15), to 4 % of their size at a strain of 0.5.
/// @param seed seed of the instrument's random numbers
Recording record(const std::vector<TrueState>& steps, const AnnularCell& cell,
                 const GrainProperties& grains, const Instrument& instrument, std::uint64_t seed);

/// Returns a recording as the text of a CSV file that `read_recording` can read, in the usual units
/// of rheometers (torque [mN m], gap [mm]), with seven digits.
std::string recording_csv(const Recording& recording);

}  // namespace pendular
