#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sim/dem/flow.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Sums over a range of grains after one time step, for kinetic stress, kinetic energy and the
/// validity of neighbour lists, reduced units. m and d are mass and diameter of a grain, v is its
/// peculiar velocity, which excludes the imposed flow.
struct MotionSums {
    Vector squares;               ///< sums of m v1^2, m v2^2, m v3^2
    double shear = 0;             ///< sum of m v1 v2
    double angular_velocity = 0;  ///< sum of m d^2 times the squared angular velocities
    /// Largest squared peculiar displacement of a grain since the narrow neighbour list was made.
    double largest_squared = 0;
    MotionSums& operator+=(const MotionSums& other);
    /// Kinetic energy of these grains, of the peculiar motion (without the imposed flow) and of the
    /// rotation [a^3 s22].
    double energy() const;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(squares, shear, angular_velocity, largest_squared);
    }
};

/// Advances velocities and positions of a range of grains (first grain, one after the last) by one
/// leapfrog step, sets their `net_forces` to zero and returns the sums over these grains.
/// Equations: dv/dt = f - L v for the peculiar velocity v (without the imposed flow), then dx/dt =
/// v + L x, f being the net force over the mass and L the imposed velocity gradient.
MotionSums advance(Grains& grains, std::pair<std::size_t, std::size_t> range,
                   std::vector<Grains::ForceAndTorque>& net_forces, const Flow& flow,
                   double time_step);

}  // namespace pendular::dem
