#pragma once

#include <limits>

#include "sim/dem/run.h"

namespace pendular::closures {

/// Averages of a state of steady shear from which the closures (analytical formulas) compute
/// stresses: the solid fraction, and properties of the contacts and of the distant pairs (pairs
/// joined by a bridge without contact). All are dimensionless; a is the grain diameter and F0 the
/// pull-off force. A dry state has an infinite reduced pressure and no distant pairs.
struct State {
    /// Reduced pressure P* = a^2 s22/F0 [1], with the imposed normal stress s22; infinite: dry.
    double reduced_pressure = std::numeric_limits<double>::infinity();
    double solid_fraction = 0;        ///< solid fraction Phi_S
    double contact_coordination = 0;  ///< contacts per grain Z_c
    double distant_coordination = 0;  ///< distant pairs per grain Z_d
    double contact_force = 0;         ///< mean elastic normal force of contacts/(a^2 s22)
    double distant_force = 0;         ///< mean attractive force of distant pairs F_d/F0
    /// Mean product of force and gap of distant pairs, <F h>_d/(F0 a).
    double distant_force_gap = 0;
    double distant_length = 1;     ///< mean distance of centres of distant pairs l0/a
    double fabric_12_contact = 0;  ///< mean of n1 n2 over contact directions n, F12c
    double fabric_12_distant = 0;  ///< mean of n1 n2 over directions of distant pairs, F12d
    /// Component 12 of the anisotropy of the force q(n) of distant pairs of direction n, negative
    /// in steady shear: integral of q n1 n2 over the sphere, divided by 4 pi and the mean of q.
    double force_anisotropy_12_distant = 0;
    /// Component 12 of the anisotropy of the distance q(n) between the centres of distant pairs of
    /// direction n: integral of q n1 n2 over the sphere, divided by 4 pi and the mean of q.
    double length_anisotropy_12_distant = 0;
};

/// Capillary stresses over F0/a^2 [1], with the pull-off force F0 of a bridge and the grain
/// diameter a. Compression is positive: bridges attract, so that the capillary normal stress is
/// negative. In the imposed shear the total shear stress is negative, so that a positive capillary
/// shear stress reduces its magnitude.
struct CapillaryStress {
    double normal = 0;  ///< normal stress a^2 s22cap/F0
    double shear = 0;   ///< shear stress a^2 s12cap/F0
};

/// Returns the averages of a simulation run from which the closures (analytical formulas) compute
/// stresses: solid fraction, coordination numbers, mean forces and anisotropies.
State network_state_of(const dem::RunResult& run);

/// Returns the capillary normal and shear stress measured in a simulation run in units of F0/a^2
/// [1], zero for a dry run. The run's observables, in units of the normal stress s22, are
/// multiplied by the reduced pressure P* = a^2 s22/F0.
CapillaryStress capillary_stress_of(const dem::RunResult& run);

}  // namespace pendular::closures
