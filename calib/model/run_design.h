#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "data/study/study.h"

namespace pendular {

/// Returns the inertial numbers [1] at which to simulate, so that readings at `conditions` can be
/// predicted. The numbers increase in equal ratios of at most 10/3, span the inertial numbers of
/// the conditions and are at least `lowest` [1]. If the prediction at a condition is extrapolated
/// (`extrapolated`), the numbers reach at least from `lowest` to 10/3 `lowest`. Otherwise, one
/// number is returned if the inertial numbers of the conditions agree within 5 %. The list is empty
/// if there are no conditions.
std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest);

/// Whether the prediction at any of `conditions` is extrapolated in the inertial number. A
/// prediction is extrapolated if the inertial number of the condition is more than 5 % below
/// `lowest`, the lowest simulated inertial number [1].
bool extrapolated(const std::vector<Condition>& conditions, double lowest);

/// Dimensionless numbers of a wet state of steady shear that is to be simulated. The friction
/// coefficient is chosen separately for each run.
struct WetSetting {
    double inverse_pressure = 0;  ///< inverse reduced pressure 1/P* [1]
    /// Liquid content Phi_L/Phi_S [1]: volume of liquid divided by volume of grains.
    double liquid_content = 0;
    double inertial_number = 0;  ///< inertial number I [1]
};

/// Returns the wet states to simulate, so that readings at the wet conditions among `conditions`
/// can be predicted. The states contain each pair of reduced pressure and liquid content of the wet
/// conditions. Pairs that agree within 5 % count as one pair. If there are more than
/// `most_wet_pairs` pairs, the function chooses `most_wet_pairs` pairs that are as far apart as
/// possible. Each pair occurs with the lowest and with the highest inertial number that
/// `inertial_numbers_for` returns for the wet conditions, or once if there is only one inertial
/// number.
/// @param lowest lowest simulated inertial number [1]
/// @throws std::invalid_argument if a condition is wet but the study has no liquid
std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest);
/// Largest number of different pairs of reduced pressure and liquid content among the wet states
/// that `wet_settings_for` returns.
constexpr std::size_t most_wet_pairs = 12;

/// Returns a point of a Latin hypercube design in the square [-1, 1]^2 for each of `settings`, in
/// the order of `settings`. The class RunPlanner varies the friction coefficient of a simulation by
/// the first coordinate, and the bridge volume by the second coordinate. The points of all settings
/// of one inertial number are evenly spread along both axes, whatever the reduced pressures and
/// liquid contents.
/// @param seed seed of the random order of the points
std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed);

}  // namespace pendular
