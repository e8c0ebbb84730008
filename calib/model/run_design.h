#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "data/study/study.h"

namespace pendular {

/// Returns the inertial numbers [1] at which to simulate, so that readings at `conditions` can be
/// predicted. They increase in equal ratios of at most 10/3, span the inertial numbers of the
/// conditions and are at least `lowest` [1]. If a prediction is `extrapolated`, they reach at least
/// from `lowest` to 10/3 `lowest`. Otherwise, one number is returned if those of the conditions
/// agree within 5 %. Empty if there are no conditions.
std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest);

/// Whether the inertial number of any condition is more than 5 % below `lowest`, the lowest
/// simulated inertial number [1], so that its prediction is extrapolated.
bool extrapolated(const std::vector<Condition>& conditions, double lowest);

/// Wet state of steady shear to simulate. The friction coefficient is chosen for each run.
struct WetSetting {
    double inverse_pressure = 0;  ///< inverse reduced pressure 1/P* [1]
    double liquid_content = 0;    ///< [1]
    double inertial_number = 0;   ///< inertial number I [1]
};

/// Returns the wet states to simulate: each pair of reduced pressure and liquid content of the wet
/// conditions among `conditions`, with the lowest and the highest inertial number of
/// `inertial_numbers_for` (once if there is only one). Pairs that agree within 5 % count as one. Of
/// more than `most_wet_pairs`, those that are as far apart as possible are chosen.
/// @param lowest lowest simulated inertial number [1]
/// @throws std::invalid_argument if a condition is wet but the study has no liquid
std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest);
/// Largest number of pairs of reduced pressure and liquid content of `wet_settings_for`. Chosen:
/// with two inertial numbers each, the first wet design has at most 24 runs.
constexpr std::size_t most_wet_pairs = 12;

/// Returns a point of a Latin hypercube design in the square [-1, 1]^2 for each of `settings`.
/// RunPlanner varies the friction coefficient by the first coordinate, the bridge volume by the
/// second. The points of all settings of one inertial number are evenly spread along both axes,
/// whatever the reduced pressures and liquid contents.
/// @param seed seed of the random order of the points
std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed);

}  // namespace pendular
