#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "sim/dem/vector.h"

namespace pendular::dem {

/// Lengths and masses of a pair of grains on which contact forces and bridge forces depend:
/// diameters d1, d2 over the mean grain diameter, masses m1, m2 over the mass of a grain of mean
/// diameter [1].
struct PairSizes {
    double contact_distance = 1;  ///< (d1 + d2)/2
    double diameter = 1;          ///< harmonic mean 2 d1 d2/(d1 + d2), for contact and bridge
    double mass = 1;              ///< harmonic mean 2 m1 m2/(m1 + m2), for the viscous force
    /// Distance from the second centre to the contact point, over half the distance of the centres.
    double second_arm = 1;

    /// Returns the sizes of a pair of grains of the diameters `first` and `second`.
    [[gnu::always_inline]] static PairSizes of(double first, double second) {
        const double first_mass = first * first * first, second_mass = second * second * second;
        const double contact_distance = 0.5 * (first + second);
        return {contact_distance, 2 * first * second / (first + second),
                2 * first_mass * second_mass / (first_mass + second_mass),
                second / contact_distance};
    }
    /// Returns the distance from the first centre, in the same unit as `second_arm`.
    double first_arm() const { return 2 - second_arm; }
};

/// Grains of a sample in reduced units: mean grain diameter, mass of a grain of mean diameter and
/// imposed normal stress are 1. The data of a grain from which the forces are computed (`motion`)
/// are adjacent in memory, and so are the computed force and torque (`net_force`): a pair
/// reads two cache lines of each of its grains and writes one.
struct Grains {
    struct Motion {
        /// Centre of the grain: inside the cell when the list of neighbouring grains was built, but
        /// possibly outside since.
        Vector position;
        /// Velocity without the imposed flow, half a time step before `position`.
        Vector velocity;
        Vector angular_velocity;  ///< half a time step before `position`

        template <typename Archive>
        void serialize(Archive& archive) {
            archive(position, velocity, angular_velocity);
        }
    };
    /// Net force and torque on one grain, in a cache line of its own.
    struct alignas(64) ForceAndTorque {
        Vector force, torque;
    };

    std::vector<Motion> motion;
    std::vector<ForceAndTorque> net_force;  ///< summed in a time step, zero between time steps
    /// Displacement of each grain, without the imposed flow, since the narrow neighbour list was
    /// made.
    std::vector<Vector> displacement;
    /// Index of each grain at the beginning of the simulation. Grains are renumbered when shear has
    /// mixed them.
    std::vector<std::int32_t> number;
    std::vector<double> diameters;  ///< empty: all 1

    explicit Grains(std::size_t count = 0)
        : motion(count), net_force(count), displacement(count), number(count) {
        std::iota(number.begin(), number.end(), 0);
    }
    std::size_t size() const { return motion.size(); }

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(motion, displacement, number, diameters);
        net_force.assign(size(), {});
    }

    double diameter(std::size_t i) const { return diameters.empty() ? 1.0 : diameters[i]; }
    double mass(std::size_t i) const {
        const double d = diameter(i);
        return d * d * d;
    }
    /// Returns the distance of the centres at which two grains touch.
    double contact_distance(std::size_t i, std::size_t j) const {
        return diameters.empty() ? 1.0 : 0.5 * (diameters[i] + diameters[j]);
    }
    PairSizes sizes(std::size_t i, std::size_t j) const {
        return diameters.empty() ? PairSizes{} : PairSizes::of(diameters[i], diameters[j]);
    }
    double largest_diameter() const {
        return diameters.empty() ? 1.0 : *std::ranges::max_element(diameters);
    }
    double smallest_diameter() const {
        return diameters.empty() ? 1.0 : *std::ranges::min_element(diameters);
    }
    /// Returns the volume of all grains.
    double volume() const {
        constexpr double of_unit = std::numbers::pi / 6;
        double cubes = diameters.empty() ? static_cast<double>(size()) : 0.0;
        for (const double d : diameters) {
            cubes += d * d * d;
        }
        return cubes * of_unit;
    }

    Vector& position(std::size_t i) { return motion[i].position; }
    Vector& velocity(std::size_t i) { return motion[i].velocity; }
    Vector& angular_velocity(std::size_t i) { return motion[i].angular_velocity; }
    const Vector& position(std::size_t i) const { return motion[i].position; }
    const Vector& velocity(std::size_t i) const { return motion[i].velocity; }
    const Vector& angular_velocity(std::size_t i) const { return motion[i].angular_velocity; }
    const Vector& force(std::size_t i) const { return net_force[i].force; }
    const Vector& torque(std::size_t i) const { return net_force[i].torque; }
};

/// Moment of inertia of a sphere of unit mass and unit diameter about its centre, (2/5)(1/2)^2. It
/// grows with the fifth power of the diameter.
constexpr double moment_of_inertia = 0.1;

}  // namespace pendular::dem
