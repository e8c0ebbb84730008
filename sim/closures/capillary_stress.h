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
/// They found values of 0.48 to 0.6 at reduced pressures of 2 and above.
constexpr double usual_distant_force = 0.5;

/// Effective coordination number [1]: number of bridges per grain that, each with the pull-off
/// force, would exert the total attraction of all bridges.
///     Z* = Z_c + Z_d F_d/F0
/// Z_c: contacts per grain, Z_d: distant bridges per grain (bridges between grains that do not
/// touch), F_d: mean force of distant bridges, F0: pull-off force.
/// Source: Badetti et al. (2018), eq:defzstar.
double effective_coordination(const State& state);

/// Approximate effective coordination number [1]: contacts per grain plus half the number per grain
/// of distant bridges (bridges between grains that do not touch). Badetti et al. (2018) use this
/// number if the mean force of distant bridges is unknown.
double approximate_coordination(const State& state);

/// Mean of the three normal stresses, divided by the normal stress s22 [1]. The function returns
/// P/s22, with P from the mean normal forces of contacts and of distant bridges (bridges between
/// grains that do not touch):
///     P = (Phi/(pi a^2)) [Z <F_N> - Z_d <F h>_d/a],   Z <F_N> = Z_c (F_contact - F0) - Z_d F_d
/// Phi: solid fraction, a: grain diameter, Z_c: contacts per grain, F_contact: their mean elastic
/// force, F0: pull-off force, Z_d: distant bridges per grain, F_d: their mean force, <F h>_d: their
/// mean product of force F and gap h, Z: contacts and distant bridges per grain, <F_N>: their mean
/// normal force. F_d and F are attractions, given as positive numbers, and reduce P. Viscous and
/// kinetic stresses and the overlaps of contacts are neglected. Badetti et al. (2018) state no
/// accuracy except that <F h>_d adds at most 2 %.
/// Source: Badetti et al. (2018), eq:PvsFN.
double mean_stress(const State& state);

/// Mean Pcap of the three normal stresses of the bridge forces, in units of F0/a^2 [1] (F0:
/// pull-off force, a: grain diameter). It is negative, since bridges attract.
///     Pcap = -(Phi/(pi a^2)) [Z_c F0 + Z_d F_d + Z_d <F h>_d/a]
/// Phi: solid fraction, Z_c: contacts per grain, Z_d: distant bridges per grain (bridges between
/// grains that do not touch), F_d: their mean force, <F h>_d: their mean product of force F and gap
/// h. The formula is exact except for overlaps. The capillary normal stress along the velocity
/// gradient differs from Pcap by at most 3 %, and by at most 2 % in most states of Badetti et al.
/// (2018).
/// Source: Badetti et al. (2018), eq:PcapvsFN.
double capillary_pressure(const State& state);

/// Estimate of Pcap, the mean of the three normal stresses that liquid bridges contribute. Returns
/// the dimensionless a^2 Pcap/F0 (F0: pull-off force, a: grain diameter), which is negative, since
/// bridges attract.
///     a^2 Pcap/F0 = -Z* Phi/pi      Phi: solid fraction, Z*: effective coordination number
/// The lengths of the gaps that bridges span are neglected; Badetti et al. (2018) call their
/// contribution negligible.
/// Source: Badetti et al. (2018), eq:cest1.
double capillary_pressure(double solid_fraction, double effective_coordination);

/// Shear stress of the bridge forces between grains in contact in units of F0/a^2 [1], positive in
/// steady shear (F0: pull-off force, a: grain diameter).
///     a^2 s12cap,c/F0 = -(3/pi) Z_c Phi F12c
/// Z_c: contacts per grain, Phi: solid fraction, F12c: mean of n1 n2 over contacts with direction n
/// (1: flow, 2: velocity gradient). The formula is exact except for overlaps.
/// Source: Badetti et al. (2018), eq:s12capcdecomp.
double contact_capillary_shear_stress(const State& state);

/// Shear stress of distant bridges (bridges between grains that do not touch) in units of F0/a^2
/// [1] (F0: pull-off force, a: grain diameter). It is negative in steady shear.
///     a^2 s12cap,d/F0 = -(3/pi) Phi Z_d (F_d/F0) (l0/a) [F12d + A_force + A_length]
/// Phi: solid fraction; Z_d: distant bridges per grain; F_d: their mean force; l0: mean distance of
/// the centres that they join; F12d: mean of n1 n2 over their directions n (1: flow, 2: velocity
/// gradient); A_force and A_length: 12 components of the anisotropies of force and distance. The
/// formula is of first order in the anisotropies; Badetti et al. (2018) call it "quite accurate".
/// The next order, -15 F12d^2 A_force in the bracket, is not small, since bridges are most frequent
/// in directions in which their force is small. Simulations at stiffness number 1000 gave
/// magnitudes 3 to 9 % larger than the formula, most at high friction.
/// Source: Badetti et al. (2018), eq:s12capddecomp.
double distant_capillary_shear_stress(const State& state);

/// Shear stress of all bridge forces in units of F0/a^2 [1] (F0: pull-off force, a: grain
/// diameter). The anisotropy of the lengths of bridges is neglected.
///     a^2 s12cap/F0 = -(3/pi) Phi [Z_c F12c + (l0/a) Z_d (F_d/F0) (F12d + A_force)]
/// Phi: solid fraction; Z_c: contacts per grain; Z_d: distant bridges per grain (bridges between
/// grains that do not touch); F12c and F12d: means of n1 n2 over the directions n of contacts and
/// of distant bridges (1: flow, 2: velocity gradient); F_d, l0 and A_force: mean force, mean
/// distance of centres and 12 component of the force anisotropy of the distant bridges. Badetti et
/// al. (2018) call the agreement "very good", on a scale from 0 to 0.1. At large liquid content the
/// contributions of contacts and distant bridges nearly cancel: relative errors are large, and
/// absolute errors are more meaningful. Simulations at stiffness number 1000 gave values smaller
/// than the formula by 0.001 to 0.011.
/// Source: Badetti et al. (2018), eq:estfinals12c.
double capillary_shear_stress(const State& state);

}  // namespace pendular::closures
