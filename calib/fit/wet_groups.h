#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Group of wet readings with about equal liquid contents and inertial numbers. The members of a
/// group are either all readings of steady shear or all points of failure (peaks of the shear
/// stress).
struct WetGroup {
    /// Indices of the group's readings in the list of all readings.
    std::vector<std::size_t> members;
    /// Liquid content (liquid volume divided by grain volume) [1], mean of the members.
    double liquid_content = 0;
    /// Inertial number I [1], mean of the members; 0 in the quasi-static limit.
    double inertial_number = 0;
    /// Whether the members of the group are points of failure (peaks of the shear stress) rather
    /// than readings of steady shear.
    bool at_failure = false;
};

/// Groups the wet readings among `readings` by liquid content and inertial number. Each member
/// agrees with the first member of the group within 2 % in liquid content and within 20 % in
/// inertial number. Quasi-static readings (inertial number 0) and points of failure form separate
/// groups. The groups are sorted by liquid content, then by inertial number, then by steady shear
/// before failure.
std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings);

/// Whether two values differ by at most `tolerance` [1] times the larger of their magnitudes.
bool agree(double a, double b, double tolerance);

/// Largest difference [1] between the inertial numbers of the first member and of any other member
/// of a `WetGroup`, relative to the larger of the two inertial numbers.
constexpr double inertial_number_tolerance = 0.2;

}  // namespace pendular
