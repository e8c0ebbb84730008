#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "data/study/study.h"

namespace pendular {

/// Returns the inertial numbers [1] at which to simulate for readings at `conditions`, in
/// increasing order and never below `lowest` [1]. The returned numbers span the inertial numbers of
/// the conditions in equal ratios of at most 10/3. If the conditions are `extrapolated`, the
/// numbers reach at least from `lowest` to 10/3 `lowest`. Otherwise one number is returned if the
/// inertial numbers of the conditions agree within 5 %. The list is empty if there are no
/// conditions.
std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest);

/// Whether the prediction at any of `conditions` is extrapolated. A prediction is extrapolated if
/// the inertial number of the condition is more than 5 % below `lowest`, the lowest inertial number
/// of the runs [1].
bool extrapolated(const std::vector<Condition>& conditions, double lowest);

/// Dimensionless numbers of a wet state of steady shear at which to simulate. The friction
/// coefficient is chosen separately for each run.
struct WetSetting {
    double inverse_pressure = 0;  ///< inverse reduced pressure 1/P* [1]
    /// Liquid content Phi_L/Phi_S [1]: volume of liquid divided by volume of grains.
    double liquid_content = 0;
    double inertial_number = 0;  ///< inertial number I [1]
};

/// Returns the settings of the runs to simulate for the wet conditions among `conditions`. The
/// settings contain each pair of reduced pressure and liquid content of the conditions. Pairs that
/// agree within 5 % count as one pair. If there are more than `most_wet_pairs` pairs, the function
/// chooses `most_wet_pairs` pairs that are as far apart as possible. Each pair occurs with the
/// lowest and with the highest inertial number of `inertial_numbers_for`, or once if there is only
/// one inertial number.
/// @param lowest lowest inertial number of the runs [1]
/// @throws std::invalid_argument if a condition is wet but the study has no liquid
std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest);
/// Largest number of pairs of reduced pressure and liquid content in the settings that
/// `wet_settings_for` returns.
constexpr std::size_t most_wet_pairs = 12;

/// Returns a point of a Latin hypercube design in the square [-1, 1]^2 for each of `settings`. The
/// planner of runs uses the coordinates of the point to vary the friction coefficient and the
/// bridge volume of a run. The points of all settings of one inertial number are evenly spread
/// along both axes, whatever the reduced pressures and liquid contents.
/// @param seed seed of the random order
std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed);

}  // namespace pendular
