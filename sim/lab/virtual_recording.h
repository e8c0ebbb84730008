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

/// Standard deviation of a step's values about the truth at a noise of 1, relative [1].
constexpr double torque_scatter = 0.01;
constexpr double solid_fraction_scatter = 0.002;

/// True steady state, with the standard errors of the simulation that found it.
struct TrueState {
    Condition condition;  ///< asked for
    Mean stress_ratio;
    Mean solid_fraction;
    std::optional<CellState> shown =
        {};  ///< what the instrument shows, where effects make it differ from the truth
};

/// Noise and sampling of an instrument.
struct Instrument {
    double noise =
        1;  ///< scatter: 1 for 1 % in torque and 0.2 % in solid fraction; 0: the simulations' alone
    int rows = 400;  ///< of each step
    /// By how much torque and solid fraction drift from the first step of a recording to the last,
    /// standard deviation, in the scatters above.
    double drift = 0;
};

/// Gives each step of a recording the mean time of its steady part [s], for a recording that begins
/// at `now`; returns the time of its last row since then [s].
double time_steps(std::vector<Condition>& steps, const GrainProperties& grains,
                  const Instrument& instrument, double now);

/// The recording an annular cell shows of steady states, one step each, a start-up first.
///
/// A step's means scatter about the infinitely long truth by `noise` times the scatters above, in
/// all: the simulation's standard error, noise within the step (a quarter of it), and, with what
/// variance those two leave, a random factor of the step. Within the step torque and gap have
/// Gaussian noise that is correlated over strains of 0.03 and 0.1, as simulated samples have; the
/// load cell has white noise of 0.2 % about its set point. The mean force of a step is thus 0.01 %
/// off.
///
/// A step lasts a strain of 20. The torque overshoots by 30 % and the sample dilates by 2 %, both
/// decaying as exp(-strain/0.15): 4 % of them are left at a strain of 0.5.
/// @param seed of the instrument's random numbers
Recording record(const std::vector<TrueState>& steps, const AnnularCell& cell,
                 const GrainProperties& grains, const Instrument& instrument, std::uint64_t seed);

/// A recording as a CSV file in the units of rheometers, seven digits each, which `read_recording`
/// reads.
std::string recording_csv(const Recording& recording);

}  // namespace pendular
