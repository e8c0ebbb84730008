#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "data/study/study.h"

namespace pendular {

/// Returns the inertial numbers [1] at which to simulate for readings at `conditions`, in
/// increasing order and never below `lowest` [1]. The returned numbers span the inertial numbers of
/// the conditions, are evenly spaced in their logarithm, and are at most a factor of 10/3 apart. If
/// the inertial number of a condition lies more than 5 % below `lowest`, the returned numbers reach
/// at least from `lowest` to 10/3 `lowest`, for extrapolation. Otherwise one number is returned if
/// the inertial numbers of the conditions agree within 5 %. The list is empty if there are no
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
/// settings contain the pairs of reduced pressure and liquid content of the conditions. Two pairs
/// count as different if reduced pressure or liquid content differ by more than 5 %. If there are
/// more than `most_wet_pairs` pairs, the function chooses `most_wet_pairs` pairs that are as far
/// apart as possible. The settings contain each pair twice: with the lowest and with the highest of
/// the inertial numbers that `inertial_numbers_for` returns for the wet conditions. If
/// `inertial_numbers_for` returns only one number, the settings contain each pair once.
/// @param lowest lowest inertial number of the runs [1]
/// @throws std::invalid_argument if a condition is wet but the study has no liquid
std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest);
/// Largest number of pairs of reduced pressure and liquid content in the settings that
/// `wet_settings_for` returns.
constexpr std::size_t most_wet_pairs = 12;

/// Returns the points of a Latin hypercube design in the square [-1, 1]^2, one point for each of
/// `settings`, in the order of `settings`. The planner of runs uses the coordinates of a point to
/// vary the friction coefficient and the bridge volume of a run. For each inertial number, the
/// points of the settings with this inertial number are evenly spread along both axes. The points
/// do not depend on the reduced pressures and liquid contents of the settings.
/// @param seed seed of the random order
std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed);

}  // namespace pendular
