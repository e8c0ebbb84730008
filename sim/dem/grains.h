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

/// Grains of a sample in reduced units (mean grain diameter, mass of a grain of mean diameter and
/// imposed normal stress are 1). The data of a grain from which the forces are computed (`motion`)
/// are adjacent in memory, and so are the computed force and torque (`net_force`). Few cache lines
/// are therefore needed per pair of grains.
struct Grains {
    struct Motion {
        /// Centre of the grain [mean grain diameters]. The centre was inside the cell when the list
        /// of neighbouring grains was built, but may have left the cell since then.
        Vector position;
        /// Velocity of the grain without the imposed flow, half a time step before the time of
        /// `position`, in reduced units.
        Vector velocity;
        /// Angular velocity of the grain, half a time step before the time of `position`, in
        /// reduced units.
        Vector angular_velocity;

        template <typename Archive>
        void serialize(Archive& archive) {
            archive(position, velocity, angular_velocity);
        }
    };
    /// Net force and torque on one grain in reduced units, in a cache line of its own.
    struct alignas(64) ForceAndTorque {
        Vector force, torque;
    };

    std::vector<Motion> motion;
    /// Net force and torque on each grain in reduced units, summed during a time step and zero
    /// between time steps.
    std::vector<ForceAndTorque> net_force;
    /// Displacement of each grain, without the imposed flow, since the list of pairs that touch or
    /// may touch soon (narrow neighbour list) was made [mean grain diameters].
    std::vector<Vector> displacement;
    /// Index of each grain, from 0, at the beginning of the simulation. Grains are renumbered when
    /// shear has mixed them.
    std::vector<std::int32_t> number;
    /// Diameter of each grain divided by the mean diameter [1]. If the list is empty, all diameters
    /// are 1.
    std::vector<double> diameters;

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
    /// Returns the mass of a grain, divided by the mass of a grain of mean diameter [1].
    double mass(std::size_t i) const {
        const double d = diameter(i);
        return d * d * d;
    }
    /// Returns the distance between the centres of two grains at which the grains touch [mean grain
    /// diameters].
    double contact_distance(std::size_t i, std::size_t j) const {
        return diameters.empty() ? 1.0 : 0.5 * (diameters[i] + diameters[j]);
    }
    /// Returns contact distance, mean diameter, mean mass and lever arm of the pair of grains i and
    /// j (`PairSizes`), on which contact forces and bridge forces depend [1].
    PairSizes sizes(std::size_t i, std::size_t j) const {
        return diameters.empty() ? PairSizes{} : PairSizes::of(diameters[i], diameters[j]);
    }
    double largest_diameter() const {
        return diameters.empty() ? 1.0 : *std::ranges::max_element(diameters);
    }
    double smallest_diameter() const {
        return diameters.empty() ? 1.0 : *std::ranges::min_element(diameters);
    }
    /// Returns the volume of all grains together [cubed mean grain diameters].
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

/// Moment of inertia of a sphere of unit mass and unit diameter about its centre, (2/5)(1/2)^2, in
/// units of (grain mass) (grain diameter)^2. The moment of inertia of a grain grows with the fifth
/// power of the diameter of the grain.
constexpr double moment_of_inertia = 0.1;

}  // namespace pendular::dem
