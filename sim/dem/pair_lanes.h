#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/dem/pair_contact.h"
#include "sim/dem/pair_laws.h"

// Memory access of the loops over pairs: functions that read the grains of one batch of pairs into
// vector lanes and add the forces of the batch to the grains. All of them are inlined into loops
// that are compiled once per instruction set.
namespace pendular::dem {

constexpr std::size_t lanes = PairList::batch;
using Lane = std::array<double, lanes>;

/// Vectors of a batch of pairs of grains, one vector per pair, stored as three arrays of
/// components.
struct alignas(64) XyzLanes {
    Lane x, y, z;

    [[gnu::always_inline]] Xyz operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
    [[gnu::always_inline]] void set(std::size_t k, const Xyz& v) {
        x[k] = v.x, y[k] = v.y, z[k] = v.z;
    }
};

/// Relative positions and velocities of the grains in a batch of pairs (`PairList::batch` pairs for
/// which forces are computed at once), and the forces and torques on the grains, in reduced units
/// (grain diameter, grain mass and imposed normal stress are 1).
struct Batch {
    /// Vector from the first to the second grain, relative velocity, and weighted sum of the
    /// angular velocities of each pair (see `PairMotion`), in reduced units.
    XyzLanes separation, velocity, angular_velocity;
    XyzLanes force;   ///< force on the second grain of each pair, in reduced units
    XyzLanes torque;  ///< torque on the second grain of each pair, in reduced units
    /// Torque on the first grain of each pair, in reduced units. This torque is used only if it
    /// differs from the torque on the second grain, `torque` (`Torques::separate`).
    XyzLanes first_torque;

    [[gnu::always_inline]] PairMotion motion(std::size_t k) const {
        return {separation[k], velocity[k], angular_velocity[k]};
    }
};

/// Mean diameters, mean masses and distances (`PairSizes`) [1] of the pairs of grains in a batch.
/// Each member is an array with one element per pair.
struct alignas(64) SizeLanes {
    Lane contact_distance, diameter, mass, second_arm;

    void set_equal() {
        contact_distance.fill(1), diameter.fill(1), mass.fill(1), second_arm.fill(1);
    }
    [[gnu::always_inline]] PairSizes operator[](std::size_t k) const {
        return {contact_distance[k], diameter[k], mass[k], second_arm[k]};
    }
    [[gnu::always_inline]] void set(std::size_t k, const PairSizes& sizes) {
        contact_distance[k] = sizes.contact_distance, diameter[k] = sizes.diameter;
        mass[k] = sizes.mass, second_arm[k] = sizes.second_arm;
    }
};

/// Sums of virials and energies over pairs of grains, and the largest overlap of the pairs (see
/// `PairSums`). Each lane (position of a pair in its batch) has a sum of its own. The order of
/// summation, and therefore the rounding, does not depend on the width of the vector unit.
struct alignas(64) LaneSums {
    Lane virial_11{}, virial_22{}, virial_33{}, virial_12{}, largest_overlap{};
    /// Sums of the stored energies and of the lost energies of the pairs (see `PairEnergy`), in
    /// units of a^3 s22, with grain diameter a and imposed normal stress s22.
    Lane elastic{}, capillary{}, friction{}, bridges{}, unloading{};

    [[gnu::always_inline]] void add_virial(std::size_t k, const Xyz& force, const Xyz& separation) {
        virial_11[k] += force.x * separation.x;
        virial_22[k] += force.y * separation.y;
        virial_33[k] += force.z * separation.z;
        virial_12[k] += force.x * separation.y;
    }
    PairSums total(EnergyAccounting accounting) const;
};

/// Displacement [grain diameters] from the periodic cell to each of its periodic images, indexed by
/// the code of the image (`image_code`). The last element is for placeholder pairs.
using Shifts = std::array<Vector, image_code::count + 1>;

inline Shifts image_shifts(const Cell& cell) {
    Shifts shifts;
    for (int code = 0; code < image_code::count; ++code) {
        shifts[code] = image_code::image(code).shift(cell);
    }
    shifts[image_code::nowhere] = {1e3, 0, 0};
    return shifts;
}

/// Transposes four vectors of four components: component k of input vector i becomes component i of
/// output vector k.
[[gnu::always_inline]] inline void transpose(const Vector::Lanes (&in)[4],
                                             Vector::Lanes (&out)[4]) {
    const auto even01 = __builtin_shufflevector(in[0], in[1], 0, 4, 2, 6);
    const auto odd01 = __builtin_shufflevector(in[0], in[1], 1, 5, 3, 7);
    const auto even23 = __builtin_shufflevector(in[2], in[3], 0, 4, 2, 6);
    const auto odd23 = __builtin_shufflevector(in[2], in[3], 1, 5, 3, 7);
    out[0] = __builtin_shufflevector(even01, even23, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
    out[2] = __builtin_shufflevector(even01, even23, 2, 3, 6, 7);
    out[3] = __builtin_shufflevector(odd01, odd23, 2, 3, 6, 7);
}

/// Writes the components of four vectors to elements k to k + 3 of the arrays `to.x`, `to.y`,
/// `to.z`.
[[gnu::always_inline]] inline void to_lanes(const Vector::Lanes (&in)[4], std::size_t k,
                                            XyzLanes& to) {
    Vector::Lanes out[4];
    transpose(in, out);
    *reinterpret_cast<Vector::Lanes*>(&to.x[k]) = out[0];
    *reinterpret_cast<Vector::Lanes*>(&to.y[k]) = out[1];
    *reinterpret_cast<Vector::Lanes*>(&to.z[k]) = out[2];
}

/// Reads four vectors from elements k to k + 3 of the arrays `from.x`, `from.y` and `from.z`.
[[gnu::always_inline]] inline void from_lanes(const XyzLanes& from, std::size_t k,
                                              Vector::Lanes (&out)[4]) {
    const Vector::Lanes in[4] = {*reinterpret_cast<const Vector::Lanes*>(&from.x[k]),
                                 *reinterpret_cast<const Vector::Lanes*>(&from.y[k]),
                                 *reinterpret_cast<const Vector::Lanes*>(&from.z[k]),
                                 Vector::Lanes{}};
    transpose(in, out);
}

/// Computes, from the grain diameters, the mean diameters, mean masses and distances (`PairSizes`)
/// [1] of the pairs in a batch.
/// @param begin index in `pairs` of the first pair of the batch
/// @param sizes receives the result, one element for each pair
[[gnu::always_inline]] inline void gather_sizes(const Grains& grains, const Pairs& pairs,
                                                std::size_t begin, SizeLanes& sizes) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    const double* diameters = grains.diameters.data();
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        sizes.set(k, PairSizes::of(diameters[first[k]], diameters[second[k]]));
    }
}

/// Quantities of the relative motion of two grains that the function `gather` reads.
enum class Gathered {
    separation,  ///< positions only, for pairs that cannot touch
    motion,      ///< positions and velocities of pairs of equal grains
    /// Positions and velocities of pairs of unequal grains, with angular velocities weighted by the
    /// distances to the contact point (`PairSizes`).
    weighted_motion,
};

/// Reads the relative positions and, unless `part` is `separation`, the relative velocities of the
/// two grains of each pair in a batch, and writes positions and velocities to the members
/// `separation`, `velocity` and `angular_velocity` of `b`.
/// @param begin index in `pairs` of the first pair of the batch
/// @param shifts displacement from the cell to each periodic image [grain diameters]
template <Gathered part>
[[gnu::always_inline]] inline void gather(const Grains::Motion* motion, const Pairs& pairs,
                                          std::size_t begin, const Shifts& shifts,
                                          const SizeLanes& sizes, Batch& b) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    const std::uint8_t* image = pairs.image.data() + begin;
    for (std::size_t k = 0; k < lanes; k += 4) {
        Vector::Lanes r[4], v[4], w[4];
        for (std::size_t l = 0; l < 4; ++l) {
            const Grains::Motion &i = motion[first[k + l]], &j = motion[second[k + l]];
            r[l] = j.position.lanes - i.position.lanes + shifts[image[k + l]].lanes;
            if constexpr (part != Gathered::separation) {
                v[l] = j.velocity.lanes - i.velocity.lanes;
            }
            if constexpr (part == Gathered::motion) {
                w[l] = j.angular_velocity.lanes + i.angular_velocity.lanes;
            } else if constexpr (part == Gathered::weighted_motion) {
                const PairSizes size = sizes[k + l];
                w[l] = size.first_arm() * i.angular_velocity.lanes +
                       size.second_arm * j.angular_velocity.lanes;
            }
        }
        to_lanes(r, k, b.separation);
        if constexpr (part != Gathered::separation) {
            to_lanes(v, k, b.velocity);
            to_lanes(w, k, b.angular_velocity);
        }
    }
}

/// Kind of the torques in a batch of pairs: no torques, equal torques or different torques on the
/// two grains of a pair.
enum class Torques {
    none,      ///< no torques, for pairs of grains that cannot touch
    shared,    ///< equal torques on both grains of a pair, in `Batch::torque`
    separate,  ///< different torques on the two grains of a pair, in `first_torque` and `torque`
};

/// Adds the forces and torques of the pairs in a batch to the net force and torque on each grain.
/// @param begin index in `pairs` of the first pair of the batch
/// @param net_force net force and torque on each grain
template <Torques torques>
[[gnu::always_inline]] inline void scatter(const Batch& b, const Pairs& pairs, std::size_t begin,
                                           Grains::ForceAndTorque* net_force) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    for (std::size_t k = 0; k < lanes; k += 4) {
        Vector::Lanes f[4], t[4], first_t[4];
        from_lanes(b.force, k, f);
        if constexpr (torques != Torques::none) {
            from_lanes(b.torque, k, t);
        }
        if constexpr (torques == Torques::separate) {
            from_lanes(b.first_torque, k, first_t);
        }
        for (std::size_t l = 0; l < 4; ++l) {
            Grains::ForceAndTorque &i = net_force[first[k + l]], &j = net_force[second[k + l]];
            j.force.lanes += f[l];
            i.force.lanes -= f[l];
            if constexpr (torques != Torques::none) {
                j.torque.lanes += t[l];
                i.torque.lanes += torques == Torques::separate ? first_t[l] : t[l];
            }
        }
    }
}

inline double sum(const Lane& lane) {
    double total = 0;
    for (const double value : lane) {
        total += value;
    }
    return total;
}

inline PairSums LaneSums::total(EnergyAccounting accounting) const {
    PairSums total{.virial_11 = sum(virial_11),
                   .virial_22 = sum(virial_22),
                   .virial_33 = sum(virial_33),
                   .virial_12 = sum(virial_12),
                   .largest_overlap = *std::ranges::max_element(largest_overlap)};
    if (accounting == EnergyAccounting::on) {
        total.energy = {.elastic = sum(elastic),
                        .capillary = sum(capillary),
                        .friction = sum(friction),
                        .bridges = sum(bridges),
                        .unloading = sum(unloading)};
    }
    return total;
}

}  // namespace pendular::dem
