#pragma once

#include <limits>

#include "sim/dem/run.h"

namespace pendular::closures {

/// Averages [1] of a state of steady shear, from which the closures compute stresses. A distant
/// pair is joined by a bridge without contact; n is the unit vector along a pair's line of centres,
/// 1 the flow and 2 the velocity gradient; a is the grain diameter, s22 the normal stress, F0 the
/// pull-off force. The anisotropy 12 of a quantity q(n) is the integral of q n1 n2 over all
/// directions, divided by 4 pi and the mean of q. A dry state has an infinite reduced pressure and
/// no distant pairs.
struct State {
    double reduced_pressure = std::numeric_limits<double>::infinity();  ///< a^2 s22/F0
    double solid_fraction = 0;
    double contact_coordination = 0;  ///< contacts per grain
    double distant_coordination = 0;  ///< distant pairs per grain
    double contact_force = 0;         ///< mean elastic normal force over a^2 s22
    double distant_force = 0;         ///< mean attraction of distant pairs over F0
    double distant_force_gap = 0;     ///< mean attraction times gap of distant pairs, over F0 a
    double distant_length = 1;        ///< mean distance of the centres of distant pairs, over a
    double fabric_12_contact = 0;     ///< mean of n1 n2 over contacts
    double fabric_12_distant = 0;     ///< mean of n1 n2 over distant pairs
    double force_anisotropy_12_distant = 0;   ///< of the attraction; negative in steady shear
    double length_anisotropy_12_distant = 0;  ///< of the distance of the centres
};

/// Stresses of the bridge forces in units of F0/a^2 [1], with pull-off force F0 and grain diameter
/// a. Compression is positive.
struct CapillaryStress {
    double normal = 0;  ///< along the velocity gradient; negative, since bridges attract
    double shear = 0;   ///< positive: lowers the magnitude of the total, negative shear stress
};

/// Returns the averages of a simulation run.
State network_state_of(const dem::RunResult& run);

/// Returns the stresses of the bridge forces that a run measured; zero for a dry run.
CapillaryStress capillary_stress_of(const dem::RunResult& run);

}  // namespace pendular::closures
