#pragma once

#include <vector>

#include "sim/dem/beads.h"
#include "sim/dem/cell.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Contact network of one state.
struct Structure {
    double contact_coordination = 0;  ///< Z_c, contacts per bead counted from both sides [1]
    double fabric_12 = 0;             ///< mean of n1 n2 over the contacts [1], eq:defF12
    double mean_overlap = 0;          ///< mean overlap over the contacts [diameters]
    double bond_order = 0;            ///< global Steinhardt Q6 of the contacts [1]

    /// Sums and means over several states.
    Structure& operator+=(const Structure& other);
    Structure& operator/=(double count);
};

/// Contacts, fabric, overlap and bond order of a state; pairs with a remembered overlap are
/// contacts.
///     Q6 = [4 pi/13 sum_m |<Y_6m(n)>|^2]^(1/2) = [<<P6(n . n')>>]^(1/2)
/// 0 for isotropic directions up to 1/sqrt(contacts); 0.575 for the fcc lattice, 0.485 for hcp.
/// Source: Steinhardt, Nelson, Ronchetti, Phys. Rev. B 28 (1983) 784.
Structure structure_of(const Beads& beads, const Cell& cell, const Pairs& pairs);

/// Velocity profile across the gradient, averaged over several instants, and its departure from
/// uniform shear.
class VelocityProfile {
  public:
    /// Adds the peculiar velocities of a state of height H [diameters], in bins of about one
    /// diameter.
    void add(const Beads& beads, double height);
    /// Localization [1]: 0 uniform shear, 1 an infinitely thin band.
    ///     Delta = 12/(H^3 rate^2) int [v1 - rate x2]^2 dx2
    /// Source: Badetti et al. (2018), eq:defdelta.
    double localization(double height, double shear_rate) const;

  private:
    std::vector<double> velocity_;  ///< summed per bin
    std::vector<double> count_;
};

}  // namespace pendular::dem
