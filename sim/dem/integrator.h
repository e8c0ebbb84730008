#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sim/dem/flow.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Sums of squared velocities over a range of grains after one time step, and the largest
/// displacement, in reduced units (grain diameter, grain mass and imposed normal stress are 1).
/// Kinetic stress, kinetic energy and the validity of the neighbour lists follow from these data.
struct MotionSums {
    /// Sums of m v1^2, m v2^2 and m v3^2 over the grains, in reduced units, with mass m and
    /// velocity v without the imposed flow. The kinetic normal stresses follow from these sums.
    Vector squares;
    /// Sum of m v1 v2 over the grains, in reduced units, with mass m and velocity v without the
    /// imposed flow. The kinetic shear stress follows from this sum.
    double shear = 0;
    /// Sum of m d^2 omega^2 over the grains, in reduced units, with mass m, diameter d and angular
    /// velocity omega. The kinetic energy of the rotation follows from this sum.
    double angular_velocity = 0;
    /// Largest squared displacement of a grain, without the imposed flow, since the list of pairs
    /// that touch or may touch soon (narrow neighbour list) was made [squared grain diameters].
    double largest_squared = 0;
    MotionSums& operator+=(const MotionSums& other);
    /// Returns the kinetic energy of the grains over which the sums were taken, in units of a^3
    /// s22, with grain diameter a and imposed normal stress s22. The energy follows from the
    /// velocities without the imposed flow and from the angular velocities.
    double energy() const;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(squares, shear, angular_velocity, largest_squared);
    }
};

/// Advances velocities, angular velocities and positions of a range of grains by one leapfrog step.
/// Sets the net forces and torques on the grains of the range to zero. Returns the sums of squared
/// velocities over the grains of the range (`MotionSums`).
///     dv/dt = f/m - L v,   dx/dt = v + L x
/// The vector x is the position of a grain, v the velocity without the imposed flow, f the net
/// force on the grain, m the mass of the grain, t the time, and L the imposed velocity gradient.
/// @param range first the index of the first grain, second the index after the last grain
/// @param net_forces net force and torque on each grain
/// @param time_step length of the time step in reduced units (grain diameter, grain mass and
///         imposed normal stress are 1)
MotionSums advance(Grains& grains, std::pair<std::size_t, std::size_t> range,
                   std::vector<Grains::ForceAndTorque>& net_forces, const Flow& flow,
                   double time_step);

}  // namespace pendular::dem
