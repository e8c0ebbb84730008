#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "sim/dem/pair_sizes.h"
#include "sim/dem/vector.h"

namespace pendular::dem {

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
