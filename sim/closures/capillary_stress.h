#pragma once

#include "sim/closures/state.h"

// Capillary stresses and mean stress from averages over contacts and bridges. All formulas follow
// from the stress as a sum over pairs of grains, with F the force on the second grain of a pair and
// r the vector from the first to the second centre:
//     s_ab = (1/volume) sum of F_a r_b,   number of pairs per volume = 3 Phi Z/(pi a^3)
// Phi is the solid fraction, a the grain diameter, and Z the number of pairs per grain, where each
// pair counts for both grains. Source of all equations: Badetti et al. (2018).
namespace pendular::closures {

/// Mean force of distant bridges (bridges between grains that do not touch), divided by the
/// pull-off force [1]. Badetti et al. (2018) assume this value if the mean force is not measured.
/// At reduced pressures of 2 and above, they found mean forces of 0.48 to 0.6 pull-off forces.
constexpr double usual_distant_force = 0.5;

/// Returns the effective coordination number Z* [1]: the number of bridges per grain that would
/// exert the total attraction of all bridges if each bridge had the pull-off force F0.
///     Z* = Z_c + Z_d F_d/F0
/// Z_c is the number of contacts per grain, Z_d the number of distant bridges per grain, and F_d
/// the mean force of distant bridges. Distant bridges join grains that do not touch.
/// Source: Badetti et al. (2018), Eq. (21).
double effective_coordination(const State& state);

/// Returns the approximate effective coordination number [1]: contacts per grain plus half the
/// number of distant bridges per grain. Distant bridges join grains that do not touch. Badetti et
/// al. (2018) use this approximation if the mean force of distant bridges is unknown.
double approximate_coordination(const State& state);

/// Returns the ratio P/s22 [1]: mean P of the three normal stresses, divided by the normal stress
/// s22 along the velocity gradient.
///     P = (Phi/(pi a^2)) [Z_c (F_contact - F0) - Z_d F_d - Z_d <F h>_d/a]
/// Phi is the solid fraction, a the grain diameter, F0 the pull-off force, Z_c the number of
/// contacts per grain, and F_contact the mean elastic force of contacts. Distant bridges join
/// grains that do not touch. Z_d is the number of distant bridges per grain, F_d the mean
/// attraction F of distant bridges, and <F h>_d the mean product of attraction F and gap h. Viscous
/// stress, kinetic stress and overlaps of contacts are neglected.
/// Source: Badetti et al. (2018), Eq. (9).
double mean_stress(const State& state);

/// Returns the mean Pcap of the three normal stresses of the bridge forces, in units of F0/a^2 [1],
/// with pull-off force F0 and grain diameter a. Pcap is negative, since bridges attract.
///     Pcap = -(Phi/(pi a^2)) [Z_c F0 + Z_d F_d + Z_d <F h>_d/a]
/// Phi is the solid fraction and Z_c the number of contacts per grain. Distant bridges join grains
/// that do not touch. Z_d is the number of distant bridges per grain, F_d the mean attraction F of
/// distant bridges, and <F h>_d the mean product of attraction F and gap h. Overlaps of contacts
/// are neglected. The capillary normal stress along the velocity gradient differs from Pcap by at
/// most 3 %.
/// Source: Badetti et al. (2018), Eq. (10).
double capillary_pressure(const State& state);

/// Returns an estimate of the mean Pcap of the three normal stresses of the bridge forces, in units
/// of F0/a^2 [1], with pull-off force F0 and grain diameter a. Pcap is negative, since bridges
/// attract.
///     a^2 Pcap/F0 = -Z* Phi/pi      Phi: solid fraction, Z*: effective coordination number
/// The estimate neglects the gaps that bridges span.
/// Source: Badetti et al. (2018), Eq. (20).
double capillary_pressure(double solid_fraction, double effective_coordination);

/// Returns the shear stress s12cap,c of the bridge forces between grains in contact, in units of
/// F0/a^2 [1], with pull-off force F0 and grain diameter a. This shear stress is positive in steady
/// shear.
///     a^2 s12cap,c/F0 = -(3/pi) Z_c Phi F12c
/// Z_c is the number of contacts per grain and Phi the solid fraction. F12c is the mean of n1 n2
/// over contacts. n1 and n2 are the components of the contact normal along the flow and along the
/// velocity gradient. Overlaps of contacts are neglected.
/// Source: Badetti et al. (2018), Eq. (28).
double contact_capillary_shear_stress(const State& state);

/// Returns the shear stress s12cap,d of distant bridges (bridges between grains that do not touch),
/// in units of F0/a^2 [1], with pull-off force F0 and grain diameter a. This shear stress is
/// negative in steady shear.
///     a^2 s12cap,d/F0 = -(3/pi) Phi Z_d (F_d/F0) (l0/a) [F12d + A_force + A_length]
/// Phi is the solid fraction, Z_d the number of distant bridges per grain, and F_d the mean force
/// of distant bridges. l0 is the mean distance between the centres of the two grains that a distant
/// bridge joins. F12d is the mean of n1 n2 over distant bridges. n1 and n2 are the components of
/// the line of centres along the flow and along the velocity gradient. A_force and A_length are the
/// anisotropies (component 12) of force and distance, `State::force_anisotropy_12_distant` and
/// `State::length_anisotropy_12_distant`. The formula is of first order in the anisotropies. At a
/// stiffness number of 1000, simulations gave magnitudes 3 to 9 % larger than the formula.
/// Source: Badetti et al. (2018), Eq. (30).
double distant_capillary_shear_stress(const State& state);

/// Returns the shear stress s12cap of all bridge forces in units of F0/a^2 [1], with pull-off force
/// F0 and grain diameter a. The formula neglects the anisotropy of the lengths of bridges.
///     a^2 s12cap/F0 = -(3/pi) Phi [Z_c F12c + (l0/a) Z_d (F_d/F0) (F12d + A_force)]
/// Phi is the solid fraction, Z_c the number of contacts per grain, and Z_d the number of distant
/// bridges per grain (bridges between grains that do not touch). F12c and F12d are the means of n1
/// n2 over contacts and over distant bridges. n1 and n2 are the components of the line of centres
/// along the flow and along the velocity gradient. For distant bridges, F_d is the mean force, l0
/// the mean distance of the centres, and A_force the anisotropy (component 12) of the force. At a
/// stiffness number of 1000, simulations gave values 0.001 to 0.011 smaller than the formula.
/// Source: Badetti et al. (2018), Eq. (31).
double capillary_shear_stress(const State& state);

}  // namespace pendular::closures
