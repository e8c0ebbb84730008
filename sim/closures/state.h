#pragma once

#include <limits>

#include "sim/dem/run.h"

namespace pendular::closures {

/// Solid fraction and the networks of contacts and of bridges without contact ("distant" pairs) of
/// a state of steady shear: what the closures relate to its stresses. Lengths are over the grain
/// diameter a. A dry state is one of infinite reduced pressure without distant pairs.
struct State {
    double reduced_pressure = std::numeric_limits<double>::infinity();  ///< P* = a^2 s22/F0
    double solid_fraction = 0;                                          ///< Phi_S
    double contact_coordination = 0;                                    ///< Z_c
    double distant_coordination = 0;                                    ///< Z_d
    double contact_force = 0;                ///< mean elastic normal force of contacts over a^2 s22
    double distant_force = 0;                ///< F_d/F0
    double distant_force_gap = 0;            ///< <F h>_d/(F0 a)
    double distant_length = 1;               ///< l0/a
    double fabric_12_contact = 0;            ///< F12c
    double fabric_12_distant = 0;            ///< F12d
    double force_anisotropy_12_distant = 0;  ///< of the force's magnitude: below 0 in shear
    double length_anisotropy_12_distant = 0;  ///< of the distance of centres
};

/// Capillary part of the stresses in units of F0/a^2 [1], compression positive: the normal one is
/// below 0, the shear one above where the total shear stress is below.
struct CapillaryStress {
    double normal = 0;  ///< a^2 s22cap/F0
    double shear = 0;   ///< a^2 s12cap/F0
};

/// Averages of a run as the closures want them.
State network_state_of(const dem::RunResult& run);

/// Capillary stresses of a run in units of F0/a^2 [1]: those it reports, which are over s22, times
/// P*. Zero for a dry run.
CapillaryStress capillary_stress_of(const dem::RunResult& run);

}  // namespace pendular::closures
