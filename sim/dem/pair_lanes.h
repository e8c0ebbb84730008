#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "sim/dem/pair_laws.h"

// What the loops over batches of pairs share: lanes in, laws of one lane, lanes out. Everything is
// inlined into loops that are compiled once per instruction set.
namespace pendular::dem {

constexpr std::size_t lanes = PairList::batch;
using Lane = std::array<double, lanes>;

/// One batch of pairs as seen by the laws, in reduced units.
struct alignas(64) Batch {
    Lane rx, ry, rz;  ///< separation from the first to the second bead
    Lane vx, vy, vz;  ///< relative velocity of the centres, without the imposed flow
    Lane wx, wy, wz;  ///< sum of the angular velocities
    Lane fx, fy, fz;  ///< force on the second bead
    Lane tx, ty, tz;  ///< torque on either bead
};

/// Sums kept per lane, so that their order does not depend on the width of the vector unit.
struct alignas(64) LaneSums {
    Lane virial_11{}, virial_22{}, virial_33{}, virial_12{}, largest_overlap{};
};
struct alignas(64) LaneEnergy {
    Lane elastic{}, capillary{}, friction{}, bridges{}, unloading{};
};

using Shifts = std::array<Vector, image_code::count + 1>;

inline Shifts image_shifts(const Cell& cell) {
    Shifts shifts;
    for (int code = 0; code < image_code::count; ++code) {
        shifts[code] = image_code::image(code).shift(cell);
    }
    shifts[image_code::nowhere] = {1e3, 0, 0};
    return shifts;
}

/// Turns four vectors into their components, or back.
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

/// Writes four vectors to lanes k to k + 3 of three components.
[[gnu::always_inline]] inline void to_lanes(const Vector::Lanes (&in)[4], std::size_t k, Lane& x,
                                            Lane& y, Lane& z) {
    Vector::Lanes out[4];
    transpose(in, out);
    *reinterpret_cast<Vector::Lanes*>(&x[k]) = out[0];
    *reinterpret_cast<Vector::Lanes*>(&y[k]) = out[1];
    *reinterpret_cast<Vector::Lanes*>(&z[k]) = out[2];
}

/// Reads four vectors from lanes k to k + 3 of three components.
[[gnu::always_inline]] inline void from_lanes(const Lane& x, const Lane& y, const Lane& z,
                                              std::size_t k, Vector::Lanes (&out)[4]) {
    const Vector::Lanes in[4] = {*reinterpret_cast<const Vector::Lanes*>(&x[k]),
                                 *reinterpret_cast<const Vector::Lanes*>(&y[k]),
                                 *reinterpret_cast<const Vector::Lanes*>(&z[k]), Vector::Lanes{}};
    transpose(in, out);
}

/// Reads separations, and where the pairs may touch the relative motion, of the pairs from `begin`
/// on: bead by bead, then turned into lanes.
template <bool moving>
[[gnu::always_inline]] inline void gather(const Beads::Motion* motion, const Pairs& pairs,
                                          std::size_t begin, const Shifts& shifts, Batch& b) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    const std::uint8_t* image = pairs.image.data() + begin;
    for (std::size_t k = 0; k < lanes; k += 4) {
        Vector::Lanes r[4], v[4], w[4];
        for (std::size_t l = 0; l < 4; ++l) {
            const Beads::Motion &i = motion[first[k + l]], &j = motion[second[k + l]];
            r[l] = j.position.lanes - i.position.lanes + shifts[image[k + l]].lanes;
            if constexpr (moving) {
                v[l] = j.velocity.lanes - i.velocity.lanes;
                w[l] = j.spin.lanes + i.spin.lanes;
            }
        }
        to_lanes(r, k, b.rx, b.ry, b.rz);
        if constexpr (moving) {
            to_lanes(v, k, b.vx, b.vy, b.vz);
            to_lanes(w, k, b.wx, b.wy, b.wz);
        }
    }
}

/// Adds the forces, and where the pairs may touch the torques, of a batch to the beads.
template <bool touching>
[[gnu::always_inline]] inline void scatter(const Batch& b, const Pairs& pairs, std::size_t begin,
                                           Beads::Load* load) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    for (std::size_t k = 0; k < lanes; k += 4) {
        Vector::Lanes f[4], t[4];
        from_lanes(b.fx, b.fy, b.fz, k, f);
        if constexpr (touching) {
            from_lanes(b.tx, b.ty, b.tz, k, t);
        }
        for (std::size_t l = 0; l < 4; ++l) {
            Beads::Load &i = load[first[k + l]], &j = load[second[k + l]];
            j.force.lanes += f[l];
            i.force.lanes -= f[l];
            if constexpr (touching) {
                j.torque.lanes += t[l];
                i.torque.lanes += t[l];
            }
        }
    }
}

[[gnu::always_inline]] inline void add_virial(const Batch& b, std::size_t k, LaneSums& sums) {
    sums.virial_11[k] += b.fx[k] * b.rx[k];
    sums.virial_22[k] += b.fy[k] * b.ry[k];
    sums.virial_33[k] += b.fz[k] * b.rz[k];
    sums.virial_12[k] += b.fx[k] * b.ry[k];
}

/// How two beads meet: geometry and relative motion of their centres.
struct Meeting {
    double distance, inverse;  ///< of the centres
    double nx, ny, nz;         ///< unit normal from the first to the second
    double vx, vy, vz;         ///< relative velocity, imposed flow included
    double normal_speed;
};

[[gnu::always_inline]] inline Meeting meet(const Batch& b, std::size_t k, const Flow& flow) {
    Meeting m;
    m.distance = std::sqrt(b.rx[k] * b.rx[k] + b.ry[k] * b.ry[k] + b.rz[k] * b.rz[k]);
    m.inverse = 1 / m.distance;
    m.nx = b.rx[k] * m.inverse, m.ny = b.ry[k] * m.inverse, m.nz = b.rz[k] * m.inverse;
    m.vx = b.vx[k] + flow.length_rate * b.rx[k] + flow.shear_rate * b.ry[k];
    m.vy = b.vy[k] + flow.height_rate * b.ry[k];
    m.vz = b.vz[k] + flow.width_rate * b.rz[k];
    m.normal_speed = m.vx * m.nx + m.vy * m.ny + m.vz * m.nz;
    return m;
}

/// Rate at which a pair turns, about its normal included.
struct Turn {
    double x, y, z;
};

/// Velocity of the centres across the normal.
struct Across {
    double x, y, z;
};

[[gnu::always_inline]] inline Across across(const Meeting& m) {
    return {m.vx - m.normal_speed * m.nx, m.vy - m.normal_speed * m.ny,
            m.vz - m.normal_speed * m.nz};
}

[[gnu::always_inline]] inline Turn turn_of(const Batch& b, std::size_t k, const Meeting& m,
                                           const Across& t) {
    const double spin = 0.5 * (b.wx[k] * m.nx + b.wy[k] * m.ny + b.wz[k] * m.nz);
    return {(m.ny * t.z - m.nz * t.y) * m.inverse + spin * m.nx,
            (m.nz * t.x - m.nx * t.z) * m.inverse + spin * m.ny,
            (m.nx * t.y - m.ny * t.x) * m.inverse + spin * m.nz};
}

/// What the tangential force of a contact needs besides its own past.
struct Grip {
    double root, old_root;  ///< sqrt(overlap), now and at the step before
    double stiffness;       ///< K_T
    double old_stiffness;   ///< at the step before, for the books
    double limit;           ///< of Coulomb
};

/// Advances the tangential force (sx, sy, sz) of a lane by one step: it turns with the pair and
/// about its normal, what points along the new normal is dropped, it is rescaled when the contact
/// unloads, and obeys the limit.
template <bool books>
[[gnu::always_inline]] inline void slide(const Batch& b, std::size_t k, const Meeting& m, double dt,
                                         const Grip& grip, double& sx, double& sy, double& sz,
                                         LaneEnergy& energy) {
    // Tangential velocity of the two surfaces where they touch, at the middle of the branch.
    const double arm = m.distance * 0.5;
    const Across t = across(m);
    const double ux = t.x - arm * (b.wy[k] * m.nz - b.wz[k] * m.ny);
    const double uy = t.y - arm * (b.wz[k] * m.nx - b.wx[k] * m.nz);
    const double uz = t.z - arm * (b.wx[k] * m.ny - b.wy[k] * m.nx);

    // The remembered force turns: s += dt Omega x s.
    const Turn o = turn_of(b, k, m, t);
    double px = sx + dt * (o.y * sz - o.z * sy);
    double py = sy + dt * (o.z * sx - o.x * sz);
    double pz = sz + dt * (o.x * sy - o.y * sx);
    const double along = px * m.nx + py * m.ny + pz * m.nz;

    // Unloading, the elastic increment of this step, and the Coulomb limit.
    const double kept = unloading_factor(grip.root, grip.old_root);
    px = kept * (px - along * m.nx);
    py = kept * (py - along * m.ny);
    pz = kept * (pz - along * m.nz);
    if constexpr (books) {
        energy.unloading[k] += tangential_energy(sx * sx + sy * sy + sz * sz, grip.old_stiffness) -
                               tangential_energy(px * px + py * py + pz * pz, grip.stiffness);
    }
    const double qx = px, qy = py, qz = pz;
    px -= dt * grip.stiffness * ux;
    py -= dt * grip.stiffness * uy;
    pz -= dt * grip.stiffness * uz;
    const double squared = px * px + py * py + pz * pz;
    const double allowed = coulomb_factor(squared, grip.limit);
    sx = px * allowed;
    sy = py * allowed;
    sz = pz * allowed;
    if constexpr (books) {
        energy.elastic[k] += tangential_energy(allowed * allowed * squared, grip.stiffness);
        energy.friction[k] +=
            sliding_loss(squared, px * qx + py * qy + pz * qz, allowed, grip.stiffness);
    }
}

/// Force on the second bead from its normal and tangential part; the torque -(arm) n x s, which
/// acts on both.
[[gnu::always_inline]] inline void assemble(Batch& b, std::size_t k, const Meeting& m,
                                            double normal_force, double sx, double sy, double sz) {
    const double arm = m.distance * 0.5;
    b.fx[k] = normal_force * m.nx + sx;
    b.fy[k] = normal_force * m.ny + sy;
    b.fz[k] = normal_force * m.nz + sz;
    b.tx[k] = -arm * (m.ny * sz - m.nz * sy);
    b.ty[k] = -arm * (m.nz * sx - m.nx * sz);
    b.tz[k] = -arm * (m.nx * sy - m.ny * sx);
}

inline double sum(const Lane& lane) {
    double total = 0;
    for (const double value : lane) {
        total += value;
    }
    return total;
}

inline PairSums total(const LaneSums& sums, const LaneEnergy& energy) {
    return {sum(sums.virial_11),
            sum(sums.virial_22),
            sum(sums.virial_33),
            sum(sums.virial_12),
            *std::ranges::max_element(sums.largest_overlap),
            {sum(energy.elastic), sum(energy.capillary), sum(energy.friction), 0.0,
             sum(energy.bridges), sum(energy.unloading)}};
}

}  // namespace pendular::dem
