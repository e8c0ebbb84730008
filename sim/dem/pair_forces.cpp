#include "sim/dem/pair_forces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/dem/simd.h"

namespace pendular::dem {
namespace {

constexpr std::size_t lanes = PairList::batch;
using Lane = std::array<double, lanes>;

/// Larger samples are fetched from memory ahead of their use, so many pairs ahead.
constexpr std::size_t cached_beads = 20'000, ahead = 2 * lanes;

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

Shifts image_shifts(const Cell& cell) {
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

/// Contact and capillary forces of a batch; pairs that do not touch get zeros without a branch.
/// What is not asked for, bridges or books, is not computed.
template <bool wet, bool books>
[[gnu::always_inline]] inline void near_batch(Batch& b, Pairs& pairs, std::size_t begin,
                                              const PairLaws& laws, LaneSums& sums,
                                              LaneEnergy& energy) {
    double* __restrict sx = pairs.sx.data() + begin;
    double* __restrict sy = pairs.sy.data() + begin;
    double* __restrict sz = pairs.sz.data() + begin;
    double* __restrict root = pairs.root.data() + begin;
    double* __restrict bridge = pairs.bridge.data() + begin;
    const double modulus = laws.material.modulus, damping = laws.material.damping;
    const double friction = laws.material.friction, dt = laws.time_step;
    const double ratio = tangential_ratio(laws.material.poisson_ratio);
    const Flow flow = laws.flow;
    const BridgeLaw bridges = laws.bridges;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        // Geometry: unit normal from the first to the second bead, overlap.
        const double distance =
            std::sqrt(b.rx[k] * b.rx[k] + b.ry[k] * b.ry[k] + b.rz[k] * b.rz[k]);
        const double inverse = 1 / distance;
        const double nx = b.rx[k] * inverse, ny = b.ry[k] * inverse, nz = b.rz[k] * inverse;
        const double overlap = distance < 1 ? 1 - distance : 0.0;
        const double vx = b.vx[k] + flow.length_rate * b.rx[k] + flow.shear_rate * b.ry[k];
        const double vy = b.vy[k] + flow.height_rate * b.ry[k];
        const double vz = b.vz[k] + flow.width_rate * b.rz[k];

        // Normal motion: elastic and viscous force.
        const double normal_speed = vx * nx + vy * ny + vz * nz;
        const Hertz hertz = Hertz::at(overlap, modulus);
        const double viscous = hertz.viscous(-normal_speed, damping);
        double normal_force = hertz.elastic + viscous;
        if constexpr (wet) {
            const double gap = distance > 1 ? distance - 1 : 0.0;
            const double joined = bridges.joined(overlap, gap, bridge[k]);
            normal_force -= joined * bridges.pull_off_force * bridges.relative_force(gap);
            if constexpr (books) {
                const double depth = bridges.potential(gap) - bridges.pull_off_force * overlap;
                energy.capillary[k] += joined * depth;
                energy.bridges[k] += (bridge[k] - joined) * depth;
            }
            bridge[k] = joined;
        }

        // Tangential velocity of the two surfaces where they touch, at the middle of the branch.
        const double arm = distance * 0.5;
        const double tx = vx - normal_speed * nx, ty = vy - normal_speed * ny,
                     tz = vz - normal_speed * nz;
        const double ux = tx - arm * (b.wy[k] * nz - b.wz[k] * ny);
        const double uy = ty - arm * (b.wz[k] * nx - b.wx[k] * nz);
        const double uz = tz - arm * (b.wx[k] * ny - b.wy[k] * nx);

        // The remembered force turns with the normal and spins about it: s += dt Omega x s, and
        // what points along the new normal is dropped.
        const double spin = 0.5 * (b.wx[k] * nx + b.wy[k] * ny + b.wz[k] * nz);
        const double ox = (ny * tz - nz * ty) * inverse + spin * nx;
        const double oy = (nz * tx - nx * tz) * inverse + spin * ny;
        const double oz = (nx * ty - ny * tx) * inverse + spin * nz;
        double px = sx[k] + dt * (oy * sz[k] - oz * sy[k]);
        double py = sy[k] + dt * (oz * sx[k] - ox * sz[k]);
        double pz = sz[k] + dt * (ox * sy[k] - oy * sx[k]);
        const double along = px * nx + py * ny + pz * nz;

        // Unloading, the elastic increment of this step, and the Coulomb limit.
        const double kept = unloading_factor(hertz.root, root[k]);
        const double stiffness = ratio * hertz.normal_stiffness;
        px = kept * (px - along * nx);
        py = kept * (py - along * ny);
        pz = kept * (pz - along * nz);
        if constexpr (books) {
            const double old_stiffness = ratio * (modulus / 2 * root[k]);
            energy.unloading[k] +=
                tangential_energy(sx[k] * sx[k] + sy[k] * sy[k] + sz[k] * sz[k], old_stiffness) -
                tangential_energy(px * px + py * py + pz * pz, stiffness);
        }
        const double qx = px, qy = py, qz = pz;
        px -= dt * stiffness * ux;
        py -= dt * stiffness * uy;
        pz -= dt * stiffness * uz;
        const double limit = friction * hertz.elastic;
        const double squared = px * px + py * py + pz * pz;
        const double allowed = coulomb_factor(squared, limit);
        sx[k] = px * allowed;
        sy[k] = py * allowed;
        sz[k] = pz * allowed;
        root[k] = hertz.root;
        if constexpr (books) {
            energy.elastic[k] +=
                hertz.energy(overlap) + tangential_energy(allowed * allowed * squared, stiffness);
            energy.friction[k] +=
                sliding_loss(squared, px * qx + py * qy + pz * qz, allowed, stiffness);
        }

        // Force on the second bead; the torque -(arm) n x s acts on both.
        b.fx[k] = normal_force * nx + sx[k];
        b.fy[k] = normal_force * ny + sy[k];
        b.fz[k] = normal_force * nz + sz[k];
        b.tx[k] = -arm * (ny * sz[k] - nz * sy[k]);
        b.ty[k] = -arm * (nz * sx[k] - nx * sz[k]);
        b.tz[k] = -arm * (nx * sy[k] - ny * sx[k]);

        add_virial(b, k, sums);
        sums.largest_overlap[k] =
            overlap > sums.largest_overlap[k] ? overlap : sums.largest_overlap[k];
    }
}

/// Attraction of a batch of distant pairs.
template <bool books>
[[gnu::always_inline]] inline void distant_batch(Batch& b, Pairs& pairs, std::size_t begin,
                                                 const BridgeLaw& law, LaneSums& sums,
                                                 LaneEnergy& energy) {
    double* __restrict bridge = pairs.bridge.data() + begin;
    const BridgeLaw bridges = law;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        const double distance =
            std::sqrt(b.rx[k] * b.rx[k] + b.ry[k] * b.ry[k] + b.rz[k] * b.rz[k]);
        const double gap = distance > 1 ? distance - 1 : 0.0;
        const double joined = bridges.joined(0.0, gap, bridge[k]);
        const double over_distance =
            -joined * bridges.pull_off_force * bridges.relative_force(gap) / distance;
        b.fx[k] = over_distance * b.rx[k];
        b.fy[k] = over_distance * b.ry[k];
        b.fz[k] = over_distance * b.rz[k];
        add_virial(b, k, sums);
        if constexpr (books) {
            const double depth = bridges.potential(gap);
            energy.capillary[k] += joined * depth;
            energy.bridges[k] += (bridge[k] - joined) * depth;
        }
        bridge[k] = joined;
    }
}

double sum(const Lane& lane) {
    double total = 0;
    for (const double value : lane) {
        total += value;
    }
    return total;
}

PairSums total(const LaneSums& sums, const LaneEnergy& energy) {
    return {sum(sums.virial_11),
            sum(sums.virial_22),
            sum(sums.virial_33),
            sum(sums.virial_12),
            *std::ranges::max_element(sums.largest_overlap),
            {sum(energy.elastic), sum(energy.capillary), sum(energy.friction), 0.0,
             sum(energy.bridges), sum(energy.unloading)}};
}

/// Asks for what a batch reads and writes of the second beads, which are spread over memory; the
/// first ones are in order.
[[gnu::always_inline]] inline void fetch(const Beads& beads, const Pairs& pairs, std::size_t begin,
                                         const Beads::Load* load) {
    for (std::size_t k = begin; k < begin + lanes; ++k) {
        const auto bead = static_cast<std::size_t>(pairs.second[k]);
        const char* motion = reinterpret_cast<const char*>(&beads.motion[bead]);
        __builtin_prefetch(motion, 1);
        __builtin_prefetch(motion + sizeof(Beads::Motion) - 1, 1);
        __builtin_prefetch(&load[bead], 1);
    }
}

template <bool wet, bool books>
[[gnu::always_inline]] inline PairSums all_near(const Beads& beads, Pairs& pairs, Stretch stretch,
                                                const PairLaws& laws, Beads::Load* load) {
    const Shifts shifts = image_shifts(laws.cell);
    Batch batch;
    LaneSums sums;
    LaneEnergy energy;
    const bool fetching = beads.size() > cached_beads;
    for (std::size_t begin = stretch.first; begin < stretch.second; begin += lanes) {
        if (fetching && begin + ahead + lanes <= pairs.size()) {
            fetch(beads, pairs, begin + ahead, load);
        }
        gather<true>(beads.motion.data(), pairs, begin, shifts, batch);
        near_batch<wet, books>(batch, pairs, begin, laws, sums, energy);
        scatter<true>(batch, pairs, begin, load);
    }
    return total(sums, energy);
}

}  // namespace

PairEnergy& PairEnergy::operator+=(const PairEnergy& other) {
    elastic += other.elastic, capillary += other.capillary, friction += other.friction;
    viscosity += other.viscosity, bridges += other.bridges, unloading += other.unloading;
    return *this;
}

PairSums& PairSums::operator+=(const PairSums& other) {
    virial_11 += other.virial_11, virial_22 += other.virial_22;
    virial_33 += other.virial_33, virial_12 += other.virial_12;
    largest_overlap = std::max(largest_overlap, other.largest_overlap);
    energy += other.energy;
    return *this;
}

PENDULAR_SIMD_CLONES
PairSums near_forces(const Beads& beads, Pairs& near, Stretch stretch, const PairLaws& laws,
                     std::vector<Beads::Load>& load) {
    const bool books = laws.books == Books::open;
    if (laws.bridges.wet()) {
        return books ? all_near<true, true>(beads, near, stretch, laws, load.data())
                     : all_near<true, false>(beads, near, stretch, laws, load.data());
    }
    return books ? all_near<false, true>(beads, near, stretch, laws, load.data())
                 : all_near<false, false>(beads, near, stretch, laws, load.data());
}

PENDULAR_SIMD_CLONES
PairSums distant_forces(const Beads& beads, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Beads::Load>& load) {
    const Shifts shifts = image_shifts(laws.cell);
    Batch batch;
    LaneSums sums;
    LaneEnergy energy;
    for (std::size_t begin = stretch.first; begin < stretch.second; begin += lanes) {
        gather<false>(beads.motion.data(), distant, begin, shifts, batch);
        if (laws.books == Books::open) {
            distant_batch<true>(batch, distant, begin, laws.bridges, sums, energy);
        } else {
            distant_batch<false>(batch, distant, begin, laws.bridges, sums, energy);
        }
        scatter<false>(batch, distant, begin, load.data());
    }
    return total(sums, energy);
}

PENDULAR_SIMD_CLONES
double viscous_loss(const Beads& beads, const std::vector<Beads::Load>& loads, const Pairs& near,
                    const PairLaws& laws) {
    const Flow flow = laws.flow;
    // The velocities halfway through the step that these forces make.
    std::vector<Beads::Motion> halfway = beads.motion;
    for (std::size_t i = 0; i < halfway.size(); ++i) {
        halfway[i].velocity +=
            0.5 * laws.time_step * (loads[i].force - flow(beads.motion[i].velocity));
    }
    const Shifts shifts = image_shifts(laws.cell);
    Batch b, mean;
    Lane loss{};
    for (std::size_t begin = 0; begin < near.size(); begin += lanes) {
        gather<true>(beads.motion.data(), near, begin, shifts, b);
        gather<true>(halfway.data(), near, begin, shifts, mean);
        const double* __restrict root = near.root.data() + begin;  // 0 where there is no contact
        for (std::size_t k = 0; k < lanes; ++k) {
            const double rx = b.rx[k], ry = b.ry[k], rz = b.rz[k];
            const double inverse = 1 / std::sqrt(rx * rx + ry * ry + rz * rz);
            const double affine = (flow.length_rate * rx + flow.shear_rate * ry) * rx +
                                  flow.height_rate * ry * ry + flow.width_rate * rz * rz;
            const double before = (b.vx[k] * rx + b.vy[k] * ry + b.vz[k] * rz + affine) * inverse;
            const double speed =
                (mean.vx[k] * rx + mean.vy[k] * ry + mean.vz[k] * rz + affine) * inverse;
            const Hertz hertz = Hertz::at(root[k] * root[k], laws.material.modulus);
            loss[k] -= laws.time_step * hertz.viscous(-before, laws.material.damping) * speed;
        }
    }
    return sum(loss);
}

PairSums pair_forces(Beads& beads, Pairs& near, const PairLaws& laws) {
    std::ranges::fill(beads.load, Beads::Load{});
    return near_forces(beads, near, {0, near.size()}, laws, beads.load);
}

}  // namespace pendular::dem
