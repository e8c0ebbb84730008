#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Sums over a range of grains after one time step, in reduced units (grain diameter, grain mass
/// and imposed normal stress are 1). m is the mass of a grain, d its diameter, v its velocity
/// without the imposed flow, omega its angular velocity. Kinetic stress, kinetic energy and the
/// validity of the neighbour lists follow from them.
struct MotionSums {
    Vector squares;               ///< sums of m v1^2, m v2^2 and m v3^2
    double shear = 0;             ///< sum of m v1 v2
    double angular_velocity = 0;  ///< sum of m d^2 omega^2
    /// Largest squared displacement of a grain, without the imposed flow, since the narrow
    /// neighbour list was made.
    double largest_squared = 0;
    MotionSums& operator+=(const MotionSums& other);
    /// Returns the kinetic energy, without the imposed flow.
    double energy() const;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(squares, shear, angular_velocity, largest_squared);
    }
};

/// Advances velocities, angular velocities and positions of a range of grains by one leapfrog step,
/// and sets the net forces and torques on them to zero. Returns the sums over the range.
///     dv/dt = f/m - L v,   dx/dt = v + L x
/// x is the position of a grain, f the net force on it and L the imposed velocity gradient. Since
/// v excludes the imposed flow, it changes by -L v where the grain moves across that flow.
/// @param range index of the first grain, and index after the last
MotionSums advance(Grains& grains, std::pair<std::size_t, std::size_t> range,
                   std::vector<Grains::ForceAndTorque>& net_forces, const Flow& flow,
                   double time_step);

}  // namespace pendular::dem
