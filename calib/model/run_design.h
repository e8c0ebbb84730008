#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "data/study/study.h"

namespace pendular {

/// Inertial numbers to simulate for readings at these: one where they agree within 5 %, else
/// enough, evenly spaced in the logarithm, that neighbours differ by a factor 10/3 at most. Never
/// below `lowest`; where a reading is, or is quasi-static (0), at least two to extrapolate from.
std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest);

/// Whether readings at these conditions are slower than runs can be, by more than 5 %, so that they
/// are extrapolated.
bool extrapolated(const std::vector<Condition>& conditions, double lowest);

/// A wet state to simulate.
struct WetSetting {
    double inverse_pressure = 0;  ///< 1/P* [1]
    double liquid_content = 0;    ///< Phi_L/Phi_S [1]
    double inertial_number = 0;   ///< I [1]
};

/// Wet settings that cover the wet ones among these conditions: every pair of reduced pressure and
/// liquid content that differs from the others by more than 5 %, or, where there are more than
/// `most_wet_pairs`, so many that lie as far from each other as possible; each at the lowest and
/// the highest inertial number of the wet conditions, never below `lowest`.
/// @throws std::invalid_argument for wet conditions of a study without a liquid
std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest);
constexpr std::size_t most_wet_pairs = 12;

/// A place in [-1, 1]^2 for each setting, random but evenly spread along both axes among the
/// settings of one inertial number, so that what is placed does not go with what is set.
std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed);

}  // namespace pendular
