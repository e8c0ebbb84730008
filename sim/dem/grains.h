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

/// Grains of a sample in reduced units (mean grain diameter, mass of a grain of that diameter and
/// imposed normal stress are 1). The numbers of one grain that the force loop reads (`motion`) are
/// adjacent in memory, and so are the numbers that it writes (`net_force`): a pair touches few
/// cache lines.
struct Grains {
    struct Motion {
        Vector position;  ///< centre; inside the cell when the neighbour list was built
        Vector velocity;  ///< peculiar (no imposed flow), half a time step before `position`
        Vector angular_velocity;  ///< angular velocity, half a time step before `position`

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
    /// Net force and torque on each grain, summed during a time step and zero between steps.
    std::vector<ForceAndTorque> net_force;
    /// Displacement of each grain without the imposed flow, since the narrow neighbour list was
    /// made.
    std::vector<Vector> displacement;
    std::vector<std::int32_t> number;  ///< original number of each grain, before renumbering
    std::vector<double> diameters;     ///< diameters of mean 1; empty: all are 1

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
    /// Mass of a grain over the mass of a grain of unit diameter [1].
    double mass(std::size_t i) const {
        const double d = diameter(i);
        return d * d * d;
    }
    /// Distance of the centres at which two grains touch [a].
    double contact_distance(std::size_t i, std::size_t j) const {
        return diameters.empty() ? 1.0 : 0.5 * (diameters[i] + diameters[j]);
    }
    /// Mean diameter, mean mass and arms (centre to contact point) of the pair of grains i and j,
    /// which enter the laws of contact and bridge.
    PairSizes sizes(std::size_t i, std::size_t j) const {
        return diameters.empty() ? PairSizes{} : PairSizes::of(diameters[i], diameters[j]);
    }
    double largest_diameter() const {
        return diameters.empty() ? 1.0 : *std::ranges::max_element(diameters);
    }
    double smallest_diameter() const {
        return diameters.empty() ? 1.0 : *std::ranges::min_element(diameters);
    }
    /// Volume of all grains together [a^3].
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

/// Moment of inertia about its centre of a sphere of unit mass and diameter, (2/5)(1/2)^2 [m a^2].
/// Moments of inertia of other grains grow with the fifth power of their diameter.
constexpr double moment_of_inertia = 0.1;

}  // namespace pendular::dem
