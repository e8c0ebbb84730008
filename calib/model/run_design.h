#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "data/study/study.h"

namespace pendular {

/// Inertial numbers I [1] of the runs to simulate for readings at `conditions`, never below
/// `lowest`: one where the inertial numbers of the conditions agree within 5 %; else as many,
/// evenly spaced in ln I, that neighbours differ by at most a factor 10/3. At least two, from which
/// to extrapolate, where the inertial number of any condition is more than 5 % below `lowest`.
/// Empty without conditions.
std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest);

/// Whether the inertial number of any of `conditions` is more than 5 % below `lowest`, the lowest
/// inertial number of the runs [1], so that the prediction there is extrapolated.
bool extrapolated(const std::vector<Condition>& conditions, double lowest);

/// Wet condition at which runs are to be simulated, given by its dimensionless numbers.
struct WetSetting {
    double inverse_pressure = 0;  ///< inverse reduced pressure 1/P* [1]
    double liquid_content = 0;    ///< volume of liquid over volume of grains Phi_L/Phi_S [1]
    double inertial_number = 0;   ///< inertial number I [1]
};

/// Settings of the runs to simulate for the wet conditions among `conditions`: all pairs of reduced
/// pressure and liquid content that differ from each other by more than 5 % in at least one of the
/// two, but at most `most_wet_pairs`, chosen as far from each other as possible. Each pair is taken
/// at the lowest and at the highest of the inertial numbers that `inertial_numbers_for` returns for
/// the wet conditions, never below `lowest` [1].
/// @throws std::invalid_argument where there are wet conditions but the study has no liquid
std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest);
/// Largest number of pairs of reduced pressure and liquid content that `wet_settings_for` returns.
constexpr std::size_t most_wet_pairs = 12;

/// Latin hypercube sample: for each of `settings` a random place in [-1, 1]^2, from which the
/// planner sets the friction and bridge volume of a run. Among the settings of one inertial number,
/// the places are evenly spread along both axes. Places are drawn without regard to the settings'
/// reduced pressures and liquid contents.
std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed);

}  // namespace pendular
