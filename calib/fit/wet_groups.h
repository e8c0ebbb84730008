#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Group of wet readings with about equal liquid contents and inertial numbers, either all of
/// steady shear or all points of failure (peaks of the shear stress).
struct WetGroup {
    std::vector<std::size_t> members;  ///< indices in the list of all readings
    double liquid_content = 0;         ///< [1], mean of the members
    double inertial_number = 0;        ///< [1], mean; 0 in the quasi-static limit
    bool at_failure = false;           ///< rather than in steady shear
};

/// Groups the wet readings by liquid content and inertial number. Each member agrees with the first
/// member of the group within 2 % in liquid content and within 20 % in inertial number.
/// Quasi-static readings (inertial number 0) and points of failure form separate groups. The groups
/// are sorted by liquid content, then by inertial number, then by steady shear before failure.
std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings);

/// Whether two values differ by at most `tolerance` [1] times the larger of their magnitudes.
bool agree(double a, double b, double tolerance);

/// Largest relative difference of inertial numbers between first and other members of a `WetGroup`.
constexpr double inertial_number_tolerance = 0.2;

}  // namespace pendular
