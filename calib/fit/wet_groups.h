#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Wet readings of one liquid content and one inertial number.
struct WetGroup {
    std::vector<std::size_t> members;  ///< indices in the list of readings
    double liquid_content = 0;         ///< Phi_L/Phi_S [1], mean of the members
    double inertial_number = 0;        ///< I [1], mean of the members; 0: the quasi-static limit
};

/// Wet readings sorted into groups whose liquid contents agree within 2 % and inertial numbers
/// within 20 %, by ascending liquid content and inertial number. The quasi-static limit, 0, is a
/// group of its own.
std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings);

/// Whether two values differ by no more than `tolerance` of the larger one.
bool agree(double a, double b, double tolerance);

/// Relative tolerance of the inertial numbers of one group [1].
constexpr double inertial_number_tolerance = 0.2;

}  // namespace pendular
