#pragma once

#include <cstdint>
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

/// Standard deviation of the mean torque and mean solid fraction of a recorded step about their
/// true values, divided by the true values [1], at `Instrument::noise` 1.
constexpr double torque_scatter = 0.01;
constexpr double solid_fraction_scatter = 0.002;

/// True steady state of the grains in one step of a virtual recording, with the standard errors of
/// the simulation that found it.
struct TrueState {
    Condition condition;  ///< requested condition
    Mean stress_ratio;    ///< true stress ratio [1]
    Mean solid_fraction;  ///< true solid fraction [1]
    /// State of the cell that the instrument shows without noise; none: equal to the true state.
    std::optional<CellState> shown = {};
};

/// Noise, drift and number of recorded rows of a virtual rheometer.
struct Instrument {
    /// Scatter of the mean torque and solid fraction of a step about their true values: 1 for
    /// standard deviations of 1 % and 0.2 %; 0 for only the statistical errors of the simulations.
    double noise = 1;
    int rows = 400;  ///< recorded rows of each step
    /// Standard deviation of the drift of torque and solid fraction from the first step of a
    /// recording to the last, in units of `torque_scatter` and `solid_fraction_scatter`.
    double drift = 0;
};

/// Sets `time` of each step's condition to the mean time of the step's steady part [s], after the
/// start-up transient, for a recording that begins at `now` [s]. Returns the time from `now` to the
/// last row of the recording [s].
double time_steps(std::vector<Condition>& steps, const GrainProperties& grains,
                  const Instrument& instrument, double now);

/// Returns the recording that an annular cell gives of a sequence of steady states, one step each.
/// Each step begins with a start-up transient.
///
/// The mean torque and gap of a step scatter about their values in an infinitely long step with a
/// relative standard deviation of `noise` times `torque_scatter` or `solid_fraction_scatter`. The
/// variance is the sum of the simulation's squared standard error, the variance from noise within
/// the step (a quarter of the standard deviation), and a random factor of the step that makes up
/// the rest. Noise of torque and gap within the step is Gaussian and correlated over strains of
/// 0.03 and 0.1, as in simulated samples. The load cell has white noise of `noise` times 0.2 %
/// about its set point, so that the mean force of a step of 400 rows is off by 0.01 %.
///
/// A step lasts a strain of 20. The torque overshoots by 30 % and the sample dilates by 2 %. Both
/// deviations decay as exp(-strain/0.15), to 4 % of their size at a strain of 0.5.
/// @param seed seed of the instrument's random numbers
Recording record(const std::vector<TrueState>& steps, const AnnularCell& cell,
                 const GrainProperties& grains, const Instrument& instrument, std::uint64_t seed);

/// Returns a recording as the text of a CSV file that `read_recording` reads, in units of
/// rheometers (torque [mN m], gap [mm]) with seven digits.
std::string recording_csv(const Recording& recording);

}  // namespace pendular
