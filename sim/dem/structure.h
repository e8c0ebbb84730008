#pragma once

#include <vector>

#include "sim/dem/beads.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Contact and bridge networks of one state, or their mean over several. Reduced units: bead
/// diameter and imposed normal stress are 1, forces of bridges are over the pull-off force F0.
/// "Distant" pairs are joined by a bridge without touching. A dry state has zeros there.
struct Structure {
    double contact_coordination = 0;         ///< Z_c, contacts per bead, counted from both sides
    double fabric_12 = 0;                    ///< F12c, mean of n1 n2 over contacts, eq:defF12
    double mean_overlap = 0;                 ///< over contacts
    double bond_order = 0;                   ///< global Steinhardt Q6 of the contacts
    double contact_force = 0;                ///< mean elastic normal force of contacts
    double force_anisotropy_12_contact = 0;  ///< of that force
    double distant_coordination = 0;         ///< Z_d
    double distant_force = 0;                ///< F_d/F0, eq:deffd
    double distant_force_gap = 0;            ///< <F h>_d/(F0 a), third term of eq:PcapvsFN
    double distant_length = 0;               ///< l0/a, mean distance of centres
    double fabric_12_distant = 0;            ///< F12d
    double force_anisotropy_12_distant = 0;  ///< eq:deffl12, that of the force's magnitude
    double length_anisotropy_12_distant = 0;
    double capillary_stress_22 = 0;  ///< over the imposed normal stress, attraction negative
    double capillary_pressure = 0;
    double capillary_shear_stress_contact = 0;
    double capillary_shear_stress_distant = 0;

    /// Sums and means over several states.
    Structure& operator+=(const Structure& other);
    Structure& operator/=(double count);

    template <typename Archive>
    void serialize(Archive& archive) {
        for (const auto member : members()) {
            archive(this->*member);
        }
    }

  private:
    static const std::vector<double Structure::*>& members();
};

/// Networks of a state, with the bridge forces that effects make of it, from its near and its
/// distant pairs; those with a remembered overlap are contacts.
///     Q6 = [4 pi/13 sum_m |<Y_6m(n)>|^2]^(1/2) = [<<P6(n . n')>>]^(1/2)
/// 0 for isotropic directions up to 1/sqrt(contacts); 0.575 for the fcc lattice, 0.485 for hcp.
/// Source: Steinhardt, Nelson, Ronchetti, Phys. Rev. B 28 (1983) 784.
///
/// The anisotropy of a quantity q(n) that depends on direction is (1/4 pi <q>) times the integral
/// of q(n) n1 n2 over the sphere (Badetti et al., eq:deffl12), from a least-squares fit of
/// spherical harmonics of order 0 and 2 to the q of all pairs.
Structure structure_of(const Beads& beads, const Cell& cell, const Pairs& near,
                       const Pairs& distant, const Material& material, const BridgeLaw& bridges,
                       const GrainEffects& effects = {});

}  // namespace pendular::dem
