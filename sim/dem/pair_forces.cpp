#include "sim/dem/pair_forces.h"

#include <algorithm>
#include <cmath>

#include "sim/dem/pair_lanes.h"
#include "sim/dem/simd.h"

namespace pendular::dem {
namespace {

/// Larger samples are fetched from memory ahead of their use, so many pairs ahead.
constexpr std::size_t cached_beads = 20'000, ahead = 2 * lanes;

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
        const Meeting m = meet(b, k, flow);
        const double overlap = m.distance < 1 ? 1 - m.distance : 0.0;

        // Normal motion: elastic and viscous force.
        const Hertz hertz = Hertz::at(overlap, modulus);
        const double viscous = hertz.viscous(-m.normal_speed, damping);
        double normal_force = hertz.elastic + viscous;
        if constexpr (wet) {
            const double gap = m.distance > 1 ? m.distance - 1 : 0.0;
            const double joined = bridges.joined(overlap, gap, bridge[k]);
            normal_force -= joined * bridges.pull_off_force * bridges.relative_force(gap);
            if constexpr (books) {
                const double depth = bridges.potential(gap) - bridges.pull_off_force * overlap;
                energy.capillary[k] += joined * depth;
                energy.bridges[k] += (bridge[k] - joined) * depth;
            }
            bridge[k] = joined;
        }
        if constexpr (books) {
            energy.elastic[k] += hertz.energy(overlap);
        }
        const Grip grip{hertz.root, root[k], ratio * hertz.normal_stiffness,
                        ratio * (modulus / 2 * root[k]), friction * hertz.elastic};
        slide<books>(b, k, m, dt, grip, sx[k], sy[k], sz[k], energy);
        root[k] = hertz.root;
        assemble(b, k, m, normal_force, sx[k], sy[k], sz[k]);
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

/// Of the viscous force between unequal beads over that between equal ones: K_N grows with
/// sqrt(d), the force with sqrt(m K_N), d and m being harmonic means.
double viscous_scale(const Beads& beads, std::size_t i, std::size_t j) {
    const double di = beads.diameter(i), dj = beads.diameter(j), mi = beads.mass(i),
                 mj = beads.mass(j);
    return std::sqrt(2 * mi * mj / (mi + mj) * std::sqrt(2 * di * dj / (di + dj)));
}

}  // namespace

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
            0.5 * laws.time_step *
            (1 / beads.mass(i) * loads[i].force - flow(beads.motion[i].velocity));
    }
    const bool sized = !beads.diameters.empty();
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
            const auto i = static_cast<std::size_t>(near.first[begin + k]),
                       j = static_cast<std::size_t>(near.second[begin + k]);
            const double scale = sized ? viscous_scale(beads, i, j) : 1.0;
            const Hertz hertz = Hertz::at(root[k] * root[k], laws.material.modulus);
            loss[k] -=
                laws.time_step * scale * hertz.viscous(-before, laws.material.damping) * speed;
        }
    }
    return sum(loss);
}

PairSums pair_forces(Beads& beads, Pairs& near, const PairLaws& laws) {
    std::ranges::fill(beads.load, Beads::Load{});
    return near_forces(beads, near, {0, near.size()}, laws, beads.load);
}

}  // namespace pendular::dem
