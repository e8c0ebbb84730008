#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "data/study/study.h"

namespace pendular {

/// Inertial numbers to simulate for readings at these conditions, never below `lowest`. One
/// inertial number where those of the readings agree within 5 %; else as many, evenly spaced in the
/// logarithm, that neighbours differ by at most a factor 10/3. For readings below `lowest` or
/// quasi-static (0) at least two, from which to extrapolate.
std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest);

/// Whether the inertial number of any condition is more than 5 % below `lowest`, the lowest of the
/// runs, so that its prediction is extrapolated.
bool extrapolated(const std::vector<Condition>& conditions, double lowest);

/// Wet condition to simulate, given by its dimensionless numbers.
struct WetSetting {
    double inverse_pressure = 0;  ///< 1/P* [1]
    double liquid_content = 0;    ///< Phi_L/Phi_S [1]
    double inertial_number = 0;   ///< I [1]
};

/// Wet settings that cover the wet conditions among `conditions`: all pairs of reduced pressure and
/// liquid content that differ from each other by more than 5 %, but at most `most_wet_pairs`,
/// chosen as far from each other as possible. Each pair is taken at the lowest and at the highest
/// inertial number of the wet conditions, never below `lowest`.
/// @throws std::invalid_argument for wet conditions of a study without a liquid
std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest);
/// Largest number of pairs of reduced pressure and liquid content that `wet_settings_for` returns.
constexpr std::size_t most_wet_pairs = 12;

/// Latin hypercube sample: a random place in [-1, 1]^2 for each setting. Among the settings of one
/// inertial number, the places are evenly spread along both axes. The quantities given by the
/// places are uncorrelated with the settings.
std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed);

}  // namespace pendular
