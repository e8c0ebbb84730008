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

/// Relative standard deviation [1] of the mean torque and mean solid fraction of a step about their
/// true values, at `Instrument::noise` 1.
constexpr double torque_scatter = 0.01;
constexpr double solid_fraction_scatter = 0.002;

/// True steady state of one step, with the standard errors of the simulation that found it.
struct TrueState {
    Condition condition;  ///< requested condition
    Mean stress_ratio;    ///< true stress ratio [1]
    Mean solid_fraction;  ///< true solid fraction [1]
    /// State that the instrument shows without noise; none: equal to the true state.
    std::optional<CellState> shown = {};
};

/// Noise and sampling of an instrument.
struct Instrument {
    /// Scatter of the means of a step: 1 for 1 % in torque and 0.2 % in solid fraction; 0 for only
    /// the statistical errors of the simulations.
    double noise = 1;
    int rows = 400;  ///< rows of each step
    /// Standard deviation of the drift of torque and solid fraction from the first step of a
    /// recording to the last, in units of `torque_scatter` and `solid_fraction_scatter`.
    double drift = 0;
};

/// Sets the time of each step to the mean time of its steady part [s], for a recording that begins
/// at `now` [s]. Returns the time from `now` to the last row of the recording [s].
double time_steps(std::vector<Condition>& steps, const GrainProperties& grains,
                  const Instrument& instrument, double now);

/// Returns the recording that an annular cell gives of a sequence of steady states, one step each.
/// Each step begins with a start-up transient.
///
/// The means of a step scatter about the values of an infinitely long step with a standard
/// deviation of `noise` times `torque_scatter` or `solid_fraction_scatter`. The variance is the sum
/// of the simulation's squared standard error, the variance from noise within the step (a quarter
/// of the standard deviation), and a random factor of the step that makes up the rest. Noise of
/// torque and gap within the step is Gaussian and correlated over strains of 0.03 and 0.1, as in
/// simulated samples. The load cell has white noise of `noise` times 0.2 % about its set point, so
/// that the mean force of a step of 400 rows is off by 0.01 %.
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
