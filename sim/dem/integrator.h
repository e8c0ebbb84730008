#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sim/dem/flow.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Sums over the grains of a range after one step.
struct MotionSums {
    Vector squares;               ///< sums of m v1^2, m v2^2, m v3^2 after the step
    double shear = 0;             ///< sum of m v1 v2
    double angular_velocity = 0;  ///< sum of m d^2 times the squared angular velocities
    double largest_squared = 0;   ///< displacement since the narrow list was made
    MotionSums& operator+=(const MotionSums& other);
    /// Kinetic energy of the peculiar motion, reduced units.
    double energy() const;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(squares, shear, angular_velocity, largest_squared);
    }
};

/// One leapfrog step of the grains of a range: dv/dt = f - L v, since v is peculiar, then dx/dt = v
/// + L x, with L the imposed velocity gradient. Sets their net forces and torques to zero.
MotionSums advance(Grains& grains, std::pair<std::size_t, std::size_t> range,
                   std::vector<Grains::ForceAndTorque>& net_forces, const Flow& flow,
                   double time_step);

}  // namespace pendular::dem
