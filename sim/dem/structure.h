#pragma once

#include <span>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Observables of the networks of contacts and bridges in one state of a sample, or means over
/// several: each STRUCTURE_OBSERVABLE of data/quantities/observables.def, in reduced units (grain
/// diameter and imposed normal stress are 1). Forces of bridges are divided by the pull-off force.
/// Capillary stresses are positive in compression. "Distant" pairs are joined by a bridge but do
/// not touch. In dry states, the members about bridges are zero.
struct Structure {
#define STRUCTURE_OBSERVABLE(name, ...) double name = 0;
#include "data/quantities/observables.def"

    /// Adds member by member; with `/=`, means over several states.
    Structure& operator+=(const Structure& other);
    Structure& operator/=(double count);

    template <typename Archive>
    void serialize(Archive& archive) {
        for (const auto member : members()) {
            archive(this->*member);
        }
    }

    /// Returns pointers to all members, in the order of the table.
    static std::span<double Structure::*const> members();
};

/// Returns the observables in one state of a sample. Pairs of `near` that overlapped in the last
/// time step are contacts. Forces of bridges include the changes by `effects`.
///
/// The bond order Q6 measures how regularly the directions n of contacts are ordered. Q6 is 0 for
/// random directions (up to 1/sqrt(number of contacts)), 0.575 in an fcc lattice and 0.485 in an
/// hcp lattice.
///     Q6 = [4 pi/13 sum_m |<Y_6m(n)>|^2]^(1/2)      Y_6m: spherical harmonics
///
/// The anisotropy (component 12) of a quantity q(n) is the integral of q n1 n2 over all directions
/// n, divided by 4 pi and the mean of q. Spherical harmonics of order 0 and 2 are fitted to the q
/// of all pairs. With fewer than 12 pairs, the anisotropy is 0.
/// @param near pairs of the narrow neighbour list, which contains all contacts
/// @param distant pairs outside of `near` that a bridge may join
/// Source: Steinhardt, Nelson, Ronchetti, Phys. Rev. B 28 (1983) 784 (Q6); Badetti et al. (2018),
/// Eq. (29) (anisotropy).
Structure structure_of(const Grains& grains, const Cell& cell, const Pairs& near,
                       const Pairs& distant, const Material& material, const BridgeLaw& bridges,
                       const GrainEffects& effects = {});

/// Returns the mean volume of all bridges over the mean volume V0 of newly formed bridges [1]; 1 if
/// all bridges have the volume V0, or if there are none.
double mean_bridge_volume(const PairList& pairs, const GrainEffects& effects);

}  // namespace pendular::dem
