#pragma once

#include <algorithm>

namespace pendular {

/// Width of the strip beside each flat side wall that adds nothing to the strength [diameters].
/// Grains beside a flat wall lie in layers, which slide over each other more easily. 0.57 +- 0.06
/// in the ten states of bench/real_cell between walls 12 diameters apart, from the stress ratio at
/// the lid under that of `sheared_layer`; states scatter by 0.2. docs/explanation/cell.md compares
/// it with cells of other widths.
constexpr double strip_without_strength = 0.57;

/// Share of the torque lost beside the side walls from which walls are called close [1]: above the
/// typical error of a torque, 2 %, by half of it. They are then closer than 38 diameters.
constexpr double loss_of_close_walls = 0.03;

/// Returns the share of the torque that is lost beside the side walls [1], for a distance between
/// them in diameters. Below ten diameters, where the layers of both walls meet, it is that of ten.
constexpr double strength_lost_beside_walls(double width) {
    return 2 * strip_without_strength / std::max(width, 10.0);
}

/// Whether side walls at this distance in diameters are close enough to tell the user.
constexpr bool walls_are_close(double width) {
    return strength_lost_beside_walls(width) >= loss_of_close_walls;
}

}  // namespace pendular
