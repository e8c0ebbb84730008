#include <algorithm>

#include "sim/dem/grain_effects.h"
#include "sim/dem/pair_forces.h"
#include "sim/dem/pair_lanes.h"
#include "sim/dem/simd.h"

// The force loop with effects on grains in it: the laws of pair_forces.cpp in stages, between which
// the effects are called. Without any effect and with equal beads it gives the same bits.
namespace pendular::dem {
namespace {

/// What the stages hand on, and what effects may see and change.
struct alignas(64) Stages {
    Lane nx, ny, nz, gap, normal_speed;
    Lane rolling_x, rolling_y, rolling_z, turn_x, turn_y, turn_z;
    Lane elastic, viscous, stiffness, root, joined, capillary, limit;
    Lane contact_distance;  ///< (d1 + d2)/2
    Lane diameter;          ///< 2 d1 d2/(d1 + d2)
    Lane mass;              ///< 2 m1 m2/(m1 + m2)
    Lane share;             ///< d2/(d1 + d2), of the arm, twice
    Lane tx, ty, tz;        ///< torque on the second bead, opposite on the first
};

/// Equal beads.
void set_equal_sizes(Stages& s) {
    s.contact_distance.fill(1), s.diameter.fill(1), s.mass.fill(1), s.share.fill(1);
}

/// Relative spins of the beads of a batch.
[[gnu::always_inline]] inline void read_rolling(const Beads::Motion* motion, const Pairs& pairs,
                                                std::size_t begin, Stages& s) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    for (std::size_t k = 0; k < lanes; k += 4) {
        Vector::Lanes w[4];
        for (std::size_t l = 0; l < 4; ++l) {
            w[l] = motion[second[k + l]].spin.lanes - motion[first[k + l]].spin.lanes;
        }
        to_lanes(w, k, s.rolling_x, s.rolling_y, s.rolling_z);
    }
}

/// Sizes of the beads of a batch; the sum of their spins, which the laws want weighted by the arms.
void read_sizes(const Beads& beads, const Pairs& pairs, std::size_t begin, Batch& b, Stages& s) {
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto i = static_cast<std::size_t>(pairs.first[begin + k]),
                   j = static_cast<std::size_t>(pairs.second[begin + k]);
        const double mi = beads.mass(i), mj = beads.mass(j);
        s.contact_distance[k] = beads.contact_distance(i, j);
        s.diameter[k] = beads.mean_diameter(i, j);
        s.mass[k] = 2 * mi * mj / (mi + mj);
        s.share[k] = beads.diameter(j) / s.contact_distance[k];
        const Vector spin = (2 - s.share[k]) * beads.spin(i) + s.share[k] * beads.spin(j);
        b.wx[k] = spin[0], b.wy[k] = spin[1], b.wz[k] = spin[2];
    }
}

/// Geometry, normal force and bridge of a batch.
template <bool wet>
[[gnu::always_inline]] inline void meet_all(const Batch& b, const Pairs& pairs, std::size_t begin,
                                            const PairLaws& laws, bool at_distance, Stages& s) {
    const double* __restrict bridge = pairs.bridge.data() + begin;
    const double ratio = tangential_ratio(laws.material.poisson_ratio);
    const double modulus = laws.material.modulus, damping = laws.material.damping;
    const double friction = laws.material.friction;
    const double always = at_distance ? 1.0 : 0.0;
    const Flow flow = laws.flow;
    const BridgeLaw bridges = laws.bridges;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        const Meeting m = meet(b, k, flow);
        const Turn turn = turn_of(b, k, m, across(m));
        const double touching = s.contact_distance[k];
        const double overlap = m.distance < touching ? touching - m.distance : 0.0;
        const double gap = m.distance > touching ? m.distance - touching : 0.0;
        const Hertz hertz = Hertz::at(overlap, modulus * std::sqrt(s.diameter[k]));
        s.nx[k] = m.nx, s.ny[k] = m.ny, s.nz[k] = m.nz;
        s.turn_x[k] = turn.x, s.turn_y[k] = turn.y, s.turn_z[k] = turn.z;
        s.gap[k] = gap - overlap;
        s.normal_speed[k] = m.normal_speed;
        s.root[k] = hertz.root;
        s.elastic[k] = hertz.elastic;
        s.stiffness[k] = ratio * hertz.normal_stiffness;
        s.viscous[k] = hertz.viscous(-m.normal_speed, damping) * std::sqrt(s.mass[k]);
        s.limit[k] = friction * hertz.elastic;
        s.joined[k] = s.capillary[k] = 0;
        if constexpr (wet) {
            const double before = bridge[k] > always ? bridge[k] : always;
            s.joined[k] = bridges.joined(overlap, gap, before);
            const BridgeLaw law = bridges.of(s.diameter[k]);
            s.capillary[k] = s.joined[k] * law.attraction(gap);
        }
    }
}

/// A batch as effects see it.
PairBatch shown(Batch& b, Stages& s, double time_step, double* const* memory) {
    return {.size = lanes,
            .time_step = time_step,
            .nx = s.nx.data(),
            .ny = s.ny.data(),
            .nz = s.nz.data(),
            .gap = s.gap.data(),
            .diameter = s.diameter.data(),
            .normal_speed = s.normal_speed.data(),
            .rolling_x = s.rolling_x.data(),
            .rolling_y = s.rolling_y.data(),
            .rolling_z = s.rolling_z.data(),
            .turn_x = s.turn_x.data(),
            .turn_y = s.turn_y.data(),
            .turn_z = s.turn_z.data(),
            .elastic = s.elastic.data(),
            .stiffness = s.stiffness.data(),
            .joined = s.joined.data(),
            .capillary = s.capillary.data(),
            .coulomb_limit = s.limit.data(),
            .fx = b.fx.data(),
            .fy = b.fy.data(),
            .fz = b.fz.data(),
            .tx = s.tx.data(),
            .ty = s.ty.data(),
            .tz = s.tz.data(),
            .memory = memory};
}

/// Tangential forces, forces and torques of a batch.
template <bool wet, bool books>
[[gnu::always_inline]] inline void load_all(Batch& b, Pairs& pairs, std::size_t begin,
                                            const PairLaws& laws, bool bridge_books, Stages& s,
                                            LaneSums& sums, LaneEnergy& energy) {
    double* __restrict sx = pairs.sx.data() + begin;
    double* __restrict sy = pairs.sy.data() + begin;
    double* __restrict sz = pairs.sz.data() + begin;
    double* __restrict root = pairs.root.data() + begin;
    double* __restrict bridge = pairs.bridge.data() + begin;
    const double ratio = tangential_ratio(laws.material.poisson_ratio);
    const double modulus = laws.material.modulus, dt = laws.time_step;
    const double booked = bridge_books ? 1.0 : 0.0;
    const Flow flow = laws.flow;
    const BridgeLaw bridges = laws.bridges;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        const Meeting m = meet(b, k, flow);
        const double overlap = s.gap[k] < 0 ? -s.gap[k] : 0.0;
        const double own_modulus = modulus * std::sqrt(s.diameter[k]);
        if constexpr (books) {
            energy.elastic[k] += Hertz::at(overlap, own_modulus).energy(overlap);
        }
        if constexpr (books && wet) {
            const double gap = s.gap[k] > 0 ? s.gap[k] : 0.0;
            const BridgeLaw law = bridges.of(s.diameter[k]);
            const double depth = booked * (law.potential(gap) - law.pull_off_force * overlap);
            energy.capillary[k] += s.joined[k] * depth;
            energy.bridges[k] += (bridge[k] - s.joined[k]) * depth;
        }
        if constexpr (wet) {
            bridge[k] = s.joined[k];
        }
        const Grip grip{s.root[k], root[k], s.stiffness[k], ratio * (own_modulus / 2 * root[k]),
                        s.limit[k]};
        slide<books>(b, k, m, dt, grip, sx[k], sy[k], sz[k], energy);
        root[k] = s.root[k];
        assemble(b, k, m, s.elastic[k] + s.viscous[k] - s.capillary[k], sx[k], sy[k], sz[k]);
        s.tx[k] = s.ty[k] = s.tz[k] = 0;
        sums.largest_overlap[k] =
            overlap > sums.largest_overlap[k] ? overlap : sums.largest_overlap[k];
    }
}

/// Adds the forces and torques of a batch to the beads, each torque by its own arm.
[[gnu::always_inline]] inline void hand_out(const Batch& b, const Stages& s, const Pairs& pairs,
                                            std::size_t begin, Beads::Load* load) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    for (std::size_t k = 0; k < lanes; k += 4) {
        Vector::Lanes f[4], t[4], own[4];
        from_lanes(b.fx, b.fy, b.fz, k, f);
        from_lanes(b.tx, b.ty, b.tz, k, t);
        from_lanes(s.tx, s.ty, s.tz, k, own);
        for (std::size_t l = 0; l < 4; ++l) {
            Beads::Load &i = load[first[k + l]], &j = load[second[k + l]];
            const double share = s.share[k + l];
            j.force.lanes += f[l];
            i.force.lanes -= f[l];
            j.torque.lanes += share * t[l] + own[l];
            i.torque.lanes += (2 - share) * t[l] - own[l];
        }
    }
}

template <bool wet, bool books>
[[gnu::always_inline]] inline PairSums all_hooked(const Beads& beads, Pairs& pairs, Stretch stretch,
                                                  const PairLaws& laws, Beads::Load* load) {
    const Shifts shifts = image_shifts(laws.cell);
    const GrainEffects& effects = *laws.effects;
    const bool sized = !beads.diameters.empty(), at_distance = effects.bridges_without_contact();
    Batch batch;
    Stages stages;
    LaneSums sums;
    LaneEnergy energy;
    set_equal_sizes(stages);
    std::vector<double*> memory(pairs.memory.size());
    for (std::size_t begin = stretch.first; begin < stretch.second; begin += lanes) {
        for (std::size_t w = 0; w < memory.size(); ++w) {
            memory[w] = pairs.memory[w].data() + begin;
        }
        gather<true>(beads.motion.data(), pairs, begin, shifts, batch);
        read_rolling(beads.motion.data(), pairs, begin, stages);
        if (sized) {
            read_sizes(beads, pairs, begin, batch, stages);
        }
        meet_all<wet>(batch, pairs, begin, laws, at_distance, stages);
        const PairBatch view = shown(batch, stages, laws.time_step, memory.data());
        effects.bridge(view, laws.material, laws.bridges);
        effects.limit(view, laws.material, laws.bridges);
        load_all<wet, books>(batch, pairs, begin, laws, !effects.changes_bridges(), stages, sums,
                             energy);
        effects.add(view, laws.material, laws.bridges);
        for (std::size_t k = 0; k < lanes; ++k) {
            add_virial(batch, k, sums);
        }
        hand_out(batch, stages, pairs, begin, load);
    }
    return total(sums, energy);
}

}  // namespace

PENDULAR_SIMD_CLONES
PairSums hooked_forces(const Beads& beads, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                       std::vector<Beads::Load>& load) {
    const bool books = laws.books == Books::open;
    if (laws.bridges.wet()) {
        return books ? all_hooked<true, true>(beads, pairs, stretch, laws, load.data())
                     : all_hooked<true, false>(beads, pairs, stretch, laws, load.data());
    }
    return books ? all_hooked<false, true>(beads, pairs, stretch, laws, load.data())
                 : all_hooked<false, false>(beads, pairs, stretch, laws, load.data());
}

}  // namespace pendular::dem
