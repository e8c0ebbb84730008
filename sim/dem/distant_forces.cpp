#include "sim/dem/distant_forces.h"

#include "sim/dem/pair_forces.h"
#include "sim/dem/pair_lanes.h"
#include "sim/dem/vector.h"

namespace pendular::dem {
namespace {

/// Computes the attraction in the batch of pairs that starts at `begin`, and breaks their bridges.
template <bool accounted>
[[gnu::always_inline]] inline void attract(Batch& b, Pairs& pairs, std::size_t begin,
                                           const BridgeLaw& law, LaneSums& sums) {
    double* __restrict bridge = pairs.bridge.data() + begin;
    const BridgeLaw bridges = law;
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        const Xyz separation = b.separation[k];
        const double distance = std::sqrt(dot(separation, separation));
        const double gap = distance > 1 ? distance - 1 : 0.0;
        const double joined = bridges.joined(0.0, gap, bridge[k]);
        const double over_distance = -joined * bridges.attraction(gap) / distance;
        const Xyz force = over_distance * separation;
        b.force.set(k, force);
        sums.add_virial(k, force, separation);
        if constexpr (accounted) {
            const double energy = bridges.potential(gap);
            sums.capillary[k] += joined * energy;
            sums.bridges[k] += (bridge[k] - joined) * energy;
        }
        bridge[k] = joined;
    }
}

PENDULAR_SIMD_CLONES
PairSums between_equal_grains(const Grains& grains, Pairs& distant, Stretch stretch,
                              const PairLaws& laws, Grains::ForceAndTorque* net_force) {
    const Shifts shifts = image_shifts(laws.cell);
    SizeLanes unused;
    Batch batch;
    LaneSums sums;
    for (std::size_t begin = stretch.first; begin < stretch.second; begin += lanes) {
        gather<Gathered::separation>(grains.motion.data(), distant, begin, shifts, unused, batch);
        if (laws.accounting == EnergyAccounting::on) {
            attract<true>(batch, distant, begin, laws.bridges, sums);
        } else {
            attract<false>(batch, distant, begin, laws.bridges, sums);
        }
        scatter<Torques::none>(batch, distant, begin, net_force);
    }
    return sums.total(laws.accounting);
}

}  // namespace

PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force) {
    const PairNeeds needs = PairNeeds::of(grains, laws);
    return needs.sizes || needs.effects
               ? pair_forces(grains, distant, stretch, laws, needs, net_force)
               : between_equal_grains(grains, distant, stretch, laws, net_force.data());
}

}  // namespace pendular::dem
