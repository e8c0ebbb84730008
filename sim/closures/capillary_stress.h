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

/// Returns the effective coordination number [1]: the number of bridges per grain that would exert
/// the total attraction of all bridges if each of them had the pull-off force.
///     Z* = Z_c + Z_d F_d/F0
/// Z_c is the number of contacts per grain, Z_d the number of distant bridges per grain (bridges
/// between grains that do not touch), F_d the mean force of distant bridges, and F0 the pull-off
/// force.
/// Source: Badetti et al. (2018), Eq. (21).
double effective_coordination(const State& state);

/// Returns the approximate effective coordination number [1]: contacts per grain plus half the
/// number of distant bridges per grain. Distant bridges join grains that do not touch. Badetti et
/// al. (2018) use this approximation if the mean force of distant bridges is unknown.
double approximate_coordination(const State& state);

/// Returns the ratio P/s22 [1], where P is the mean of the three normal stresses and s22 the normal
/// stress along the velocity gradient. P follows from the mean normal forces of contacts and of
/// distant bridges (bridges between grains that do not touch):
///     P = (Phi/(pi a^2)) [Z <F_N> - Z_d <F h>_d/a],   Z <F_N> = Z_c (F_contact - F0) - Z_d F_d
/// Phi is the solid fraction, a the grain diameter, and F0 the pull-off force. Z_c is the number of
/// contacts per grain, and F_contact the mean elastic force of contacts. Z_d is the number of
/// distant bridges per grain, F_d the mean force of distant bridges, and <F h>_d the mean product
/// of force F and gap h of distant bridges. Z is the number of contacts and distant bridges per
/// grain, and <F_N> the mean normal force of contacts and distant bridges. F_d and F are
/// attractions, given as positive numbers, and reduce P. Viscous stress, kinetic stress and the
/// overlaps of contacts are neglected. Badetti et al. (2018) state no accuracy except that <F h>_d
/// adds at most 2 %.
/// Source: Badetti et al. (2018), Eq. (9).
double mean_stress(const State& state);

/// Returns the mean Pcap of the three normal stresses of the bridge forces, in units of F0/a^2 [1],
/// with pull-off force F0 and grain diameter a. Pcap is negative, since bridges attract.
///     Pcap = -(Phi/(pi a^2)) [Z_c F0 + Z_d F_d + Z_d <F h>_d/a]
/// Phi is the solid fraction, Z_c the number of contacts per grain, Z_d the number of distant
/// bridges per grain (bridges between grains that do not touch), F_d the mean force of distant
/// bridges, and <F h>_d the mean product of force F and gap h of distant bridges. The only
/// approximation is that overlaps of grains in contact are neglected. The capillary normal stress
/// along the velocity gradient differs from Pcap by at most 3 %, and by at most 2 % in most states
/// of Badetti et al. (2018).
/// Source: Badetti et al. (2018), Eq. (10).
double capillary_pressure(const State& state);

/// Returns an estimate of a^2 Pcap/F0 [1], where Pcap is the mean of the three normal stresses of
/// the bridge forces, F0 the pull-off force and a the grain diameter. The estimate is negative,
/// since bridges attract.
///     a^2 Pcap/F0 = -Z* Phi/pi      Phi: solid fraction, Z*: effective coordination number
/// The gaps that bridges span are neglected. Badetti et al. (2018) call the contribution of the
/// gaps negligible.
/// Source: Badetti et al. (2018), Eq. (20).
double capillary_pressure(double solid_fraction, double effective_coordination);

/// Returns the shear stress of the bridge forces between grains in contact, in units of F0/a^2 [1],
/// with pull-off force F0 and grain diameter a. This shear stress is positive in steady shear.
///     a^2 s12cap,c/F0 = -(3/pi) Z_c Phi F12c
/// Z_c is the number of contacts per grain, Phi the solid fraction, and F12c the mean of n1 n2 over
/// contacts with direction n. Direction 1 is the flow, direction 2 the velocity gradient. The only
/// approximation is that overlaps of grains in contact are neglected.
/// Source: Badetti et al. (2018), Eq. (28).
double contact_capillary_shear_stress(const State& state);

/// Returns the shear stress of distant bridges (bridges between grains that do not touch), in units
/// of F0/a^2 [1], with pull-off force F0 and grain diameter a. This shear stress is negative in
/// steady shear.
///     a^2 s12cap,d/F0 = -(3/pi) Phi Z_d (F_d/F0) (l0/a) [F12d + A_force + A_length]
/// Phi is the solid fraction, Z_d the number of distant bridges per grain, F_d the mean force of
/// distant bridges, and l0 the mean distance of the centres that distant bridges join. F12d is the
/// mean of n1 n2 over distant bridges with direction n. Direction 1 is the flow, direction 2 the
/// velocity gradient. A_force and A_length are the anisotropies (component 12) of force and
/// distance. The formula is of first order in the anisotropies. Badetti et al. (2018) call the
/// formula "quite accurate". The contribution of the next order, -15 F12d^2 A_force in the bracket,
/// is not small, since bridges are most frequent in directions in which their force is small.
/// Simulations at a stiffness number of 1000 gave magnitudes 3 to 9 % larger than the formula. The
/// difference was largest at a high friction coefficient.
/// Source: Badetti et al. (2018), Eq. (30).
double distant_capillary_shear_stress(const State& state);

/// Returns the shear stress of all bridge forces in units of F0/a^2 [1], with pull-off force F0 and
/// grain diameter a. The anisotropy of the lengths of bridges is neglected.
///     a^2 s12cap/F0 = -(3/pi) Phi [Z_c F12c + (l0/a) Z_d (F_d/F0) (F12d + A_force)]
/// Phi is the solid fraction, Z_c the number of contacts per grain, and Z_d the number of distant
/// bridges per grain (bridges between grains that do not touch). F12c and F12d are the means of n1
/// n2 over the directions n of contacts and of distant bridges. Direction 1 is the flow, direction
/// 2 the velocity gradient. For distant bridges, F_d is the mean force, l0 the mean distance of the
/// centres, and A_force the force anisotropy (component 12). Badetti et al. (2018) call the formula
/// a "very good estimate", judged on a scale from 0 to 0.1. At a large liquid content, the
/// contributions of contacts and of distant bridges nearly cancel. Relative errors are then large,
/// and absolute errors are more meaningful. Simulations at a stiffness number of 1000 gave values
/// smaller than the formula by 0.001 to 0.011.
/// Source: Badetti et al. (2018), Eq. (31).
double capillary_shear_stress(const State& state);

}  // namespace pendular::closures
