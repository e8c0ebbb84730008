#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/dem/pair_contact.h"
#include "sim/dem/pair_laws.h"

// Memory access of the loops over pairs: functions that read the grains of one batch of pairs into
// vector lanes and add the forces of the batch to the grains. All of them are inlined into loops
// that are compiled once per instruction set. `begin` is the index of the batch's first pair.
namespace pendular::dem {

constexpr std::size_t lanes = PairList::batch;
using Lane = std::array<double, lanes>;

/// Vectors of a batch of pairs, as three arrays of components.
struct alignas(64) XyzLanes {
    Lane x, y, z;

    [[gnu::always_inline]] Xyz operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
    [[gnu::always_inline]] void set(std::size_t k, const Xyz& v) {
        x[k] = v.x, y[k] = v.y, z[k] = v.z;
    }
};

/// Relative positions and velocities of the grains in a batch, and the forces and torques on them,
/// in reduced units (grain diameter, grain mass and imposed normal stress are 1).
struct Batch {
    XyzLanes separation, velocity, angular_velocity;  ///< as `PairMotion`
    XyzLanes force;                                   ///< on the second grain
    XyzLanes torque;                                  ///< on the second grain
    XyzLanes first_torque;  ///< on the first grain, if `Torques::separate`

    [[gnu::always_inline]] PairMotion motion(std::size_t k) const {
        return {separation[k], velocity[k], angular_velocity[k]};
    }
};

/// `PairSizes` of a batch.
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

/// `PairSums` in the making. Each lane (position of a pair in its batch) has a sum of its own, so
/// that the order of summation, and with it the rounding, does not depend on the width of the
/// vector unit.
struct alignas(64) LaneSums {
    Lane virial_11{}, virial_22{}, virial_33{}, virial_12{}, largest_overlap{};
    Lane elastic{}, capillary{}, friction{}, bridges{}, unloading{};  ///< as `PairEnergy`

    [[gnu::always_inline]] void add_virial(std::size_t k, const Xyz& force, const Xyz& separation) {
        virial_11[k] += force.x * separation.x;
        virial_22[k] += force.y * separation.y;
        virial_33[k] += force.z * separation.z;
        virial_12[k] += force.x * separation.y;
    }
    PairSums total(EnergyAccounting accounting) const;
};

/// Displacement [grain diameters] from the cell to each of its periodic images, by `image_code`.
/// The last element is for placeholder pairs.
using Shifts = std::array<Vector, image_code::count + 1>;

inline Shifts image_shifts(const Cell& cell) {
    Shifts shifts;
    for (int code = 0; code < image_code::count; ++code) {
        shifts[code] = image_code::image(code).shift(cell);
    }
    shifts[image_code::nowhere] = {1e3, 0, 0};
    return shifts;
}

/// Transposes four vectors: component k of input i becomes component i of output k.
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

/// Writes four vectors to elements k to k + 3 of `to`; k is a multiple of 4.
[[gnu::always_inline]] inline void to_lanes(const Vector::Lanes (&in)[4], std::size_t k,
                                            XyzLanes& to) {
    Vector::Lanes out[4];
    transpose(in, out);
    *reinterpret_cast<Vector::Lanes*>(&to.x[k]) = out[0];
    *reinterpret_cast<Vector::Lanes*>(&to.y[k]) = out[1];
    *reinterpret_cast<Vector::Lanes*>(&to.z[k]) = out[2];
}

/// Reads four vectors from elements k to k + 3 of `from`.
[[gnu::always_inline]] inline void from_lanes(const XyzLanes& from, std::size_t k,
                                              Vector::Lanes (&out)[4]) {
    const Vector::Lanes in[4] = {*reinterpret_cast<const Vector::Lanes*>(&from.x[k]),
                                 *reinterpret_cast<const Vector::Lanes*>(&from.y[k]),
                                 *reinterpret_cast<const Vector::Lanes*>(&from.z[k]),
                                 Vector::Lanes{}};
    transpose(in, out);
}

/// Computes the `PairSizes` of the pairs in a batch.
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

/// Relative motion that `gather` reads.
enum class Gathered {
    separation,  ///< for pairs that cannot touch
    motion,      ///< positions and velocities, for equal grains
    /// Positions and velocities, with angular velocities weighted by the distances to the contact
    /// point, for unequal grains.
    weighted_motion,
};

/// Reads the relative motion of the pairs in a batch into `b`.
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

/// Torques in a batch of pairs.
enum class Torques {
    none,      ///< for pairs that cannot touch
    shared,    ///< equal on both grains, in `Batch::torque`
    separate,  ///< in `first_torque` and `torque`
};

/// Adds the forces and torques of a batch to the net force and torque on each grain.
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
