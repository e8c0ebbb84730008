#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Group of wet readings with the same liquid content and the same inertial number.
struct WetGroup {
    std::vector<std::size_t> members;  ///< indices of the readings in the list of all readings
    double liquid_content = 0;         ///< Phi_L/Phi_S [1], mean of the members
    double inertial_number = 0;        ///< I [1], mean of the members; 0: the quasi-static limit
};

/// Groups the wet readings: within a group, liquid contents agree within 2 % and inertial numbers
/// within 20 %. Quasi-static readings (inertial number 0) form groups of their own. Groups are
/// sorted by liquid content, then by inertial number.
std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings);

/// Whether two values differ by at most `tolerance` times the larger of their magnitudes.
bool agree(double a, double b, double tolerance);

/// Relative tolerance of the inertial numbers of one group [1].
constexpr double inertial_number_tolerance = 0.2;

}  // namespace pendular
