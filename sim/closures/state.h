#pragma once

#include <limits>

#include "sim/dem/run.h"

namespace pendular::closures {

/// Averages of a state of steady shear, from which the closures (analytical formulas) compute
/// stresses. All averages are dimensionless. A distant pair consists of two grains that a bridge
/// joins without contact. A dry state has an infinite reduced pressure and no distant pairs.
struct State {
    /// Reduced pressure a^2 s22/F0 [1], with grain diameter a, imposed normal stress s22 and
    /// pull-off force F0. For dry grains, the reduced pressure is infinite.
    double reduced_pressure = std::numeric_limits<double>::infinity();
    double solid_fraction = 0;        ///< solid fraction of the sample [1]
    double contact_coordination = 0;  ///< mean number of contacts per grain [1]
    /// Mean number of distant pairs per grain [1]. A distant pair consists of two grains that a
    /// bridge joins but that do not touch.
    double distant_coordination = 0;
    /// Mean elastic normal force of contacts divided by a^2 s22 [1], with grain diameter a and
    /// normal stress s22.
    double contact_force = 0;
    /// Mean attractive force of distant pairs (joined by a bridge but not touching), divided by the
    /// pull-off force [1].
    double distant_force = 0;
    /// Mean product of force and gap of distant pairs (joined by a bridge but not touching),
    /// divided by pull-off force times grain diameter [1].
    double distant_force_gap = 0;
    /// Mean distance between the centres of the two grains of a distant pair (joined by a bridge
    /// but not touching), divided by the grain diameter [1].
    double distant_length = 1;
    /// Mean of n1 n2 over contacts [1], where n1 and n2 are the components of the contact direction
    /// along the flow and along the velocity gradient.
    double fabric_12_contact = 0;
    /// Mean of n1 n2 over distant pairs (joined by a bridge but not touching) [1], where n1 and n2
    /// are the components of the line of centres along the flow and along the velocity gradient.
    double fabric_12_distant = 0;
    /// Component 12 of the anisotropy of the force of distant pairs (joined by a bridge but not
    /// touching) [1]: the integral of q n1 n2 over all directions n, divided by 4 pi and the mean
    /// of q. q(n) is the mean force of distant pairs whose line of centres is n. n1 and n2 are the
    /// components of n along the flow and along the velocity gradient. The anisotropy is negative
    /// in steady shear.
    double force_anisotropy_12_distant = 0;
    /// Component 12 of the anisotropy of the distance between the centres of distant pairs (joined
    /// by a bridge but not touching) [1]: the integral of q n1 n2 over all directions n, divided by
    /// 4 pi and the mean of q. q(n) is the mean distance of distant pairs whose line of centres is
    /// n. n1 and n2 are the components of n along the flow and along the velocity gradient.
    double length_anisotropy_12_distant = 0;
};

/// Stresses of the bridge forces in units of F0/a^2 [1], with pull-off force F0 and grain diameter
/// a. Compression is positive. The normal stress of the bridge forces is negative, since bridges
/// attract. The total shear stress of the sample is negative. A positive shear stress of the bridge
/// forces therefore reduces the magnitude of the total shear stress.
struct CapillaryStress {
    /// Normal stress of the bridge forces along the velocity gradient, in units of F0/a^2 [1], with
    /// pull-off force F0 and grain diameter a. Attraction makes the normal stress negative.
    double normal = 0;
    /// Shear stress of the bridge forces in units of F0/a^2 [1], with pull-off force F0 and grain
    /// diameter a. A positive shear stress reduces the magnitude of the total shear stress.
    double shear = 0;
};

/// Returns the averages of a simulation run from which the closures (analytical formulas) compute
/// stresses: solid fraction, coordination numbers, mean forces and anisotropies.
State network_state_of(const dem::RunResult& run);

/// Returns the normal stress and the shear stress of the bridge forces that a simulation run
/// measured, in units of F0/a^2 [1], with pull-off force F0 and grain diameter a. Both stresses are
/// zero for a dry run.
CapillaryStress capillary_stress_of(const dem::RunResult& run);

}  // namespace pendular::closures
