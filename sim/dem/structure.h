#pragma once

#include <span>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Observables of the contact and bridge networks in one state, or their means over several states:
/// a member for each STRUCTURE_OBSERVABLE of data/quantities/observables.def. Reduced units: grain
/// diameter and imposed normal stress are 1, forces of bridges are over the pull-off force F0,
/// capillary stresses are over the imposed normal stress and negative for attraction. "Distant"
/// pairs are joined by a bridge without touching. In dry states the members about bridges are zero.
struct Structure {
#define STRUCTURE_OBSERVABLE(name, ...) double name = 0;
#include "data/quantities/observables.def"

    /// Adds the observables of another state, member by member. After the states are summed, `/=`
    /// by their number gives their mean.
    Structure& operator+=(const Structure& other);
    Structure& operator/=(double count);

    template <typename Archive>
    void serialize(Archive& archive) {
        for (const auto member : members()) {
            archive(this->*member);
        }
    }

    /// Pointers to all members, in the order of observables.def.
    static std::span<double Structure::*const> members();
};

/// Computes the observables of the contact and bridge networks in one state from its pairs `near`
/// (narrow list) and `distant` (other pairs that a bridge may join); bridge forces include changes
/// by `effects`. Near pairs that overlapped in the last step are contacts. Their bond order is
///     Q6 = [4 pi/13 sum_m |<Y_6m(n)>|^2]^(1/2) = [<<P6(n . n')>>]^(1/2),
/// n being the contact directions: 0 for isotropic directions up to 1/sqrt(contacts), 0.575 for the
/// fcc lattice, 0.485 for hcp.
/// Source: Steinhardt, Nelson, Ronchetti, Phys. Rev. B 28 (1983) 784.
///
/// The anisotropy of a quantity q(n) that depends on direction is (1/4 pi <q>) times the integral
/// of q(n) n1 n2 over the sphere (Badetti et al., eq:deffl12), from a least-squares fit of
/// spherical harmonics of order 0 and 2 to the q of all pairs.
Structure structure_of(const Grains& grains, const Cell& cell, const Pairs& near,
                       const Pairs& distant, const Material& material, const BridgeLaw& bridges,
                       const GrainEffects& effects = {});

}  // namespace pendular::dem
