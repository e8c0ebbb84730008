#pragma once

#include "sim/closures/state.h"

// Capillary stresses and mean stress from averages over contacts and bridges, all derived from
//     s_ab = (1/volume) sum over pairs of F_a r_b,   pairs per volume = 3 Phi Z/(pi a^3)
// where Z is the number of pairs per grain, each pair counted for both grains. Source of all
// equations: Badetti et al. (2018).
namespace pendular::closures {

/// Mean force of bridges without contact over the pull-off force, F_d/F0 [1], that Badetti et al.
/// (2018) assume where it is not measured; they found 0.48 to 0.6 for P* >= 2.
constexpr double usual_distant_force = 0.5;

/// Effective coordination number Z* = Z_c + Z_d F_d/F0 [1], from Z_c contacts and Z_d bridges
/// without contact per grain, the latter with mean force F_d: number of bridges per grain that,
/// each with the force F0, would exert the total attraction of all bridges. Source: eq:defzstar.
double effective_coordination(const State& state);

/// Approximate effective coordination number Z* = Z_c + 0.5 Z_d [1], from Z_c contacts and Z_d
/// bridges without contact per grain. Badetti et al. (2018) use it where the mean force of bridges
/// without contact is unknown.
double approximate_coordination(const State& state);

/// Mean stress P = tr(s)/3 over the normal stress s22 [1], from the mean normal forces of pairs in
/// contact (F_contact elastic, F0 capillary) and of bridges without contact (F_d, gap h):
///     P = (Phi/(pi a^2)) [Z <F_N> + Z_d <F h>_d/a],   Z <F_N> = Z_c (F_contact - F0) - Z_d F_d
/// Neglects viscous and kinetic stresses and the overlaps of grains in contact, whose centres are
/// closer than a. Badetti et al. (2018) state no accuracy except that <F h>_d adds at most 2 %.
/// Source: eq:PvsFN.
double mean_stress(const State& state);

/// Mean capillary stress Pcap = tr(scap)/3 times a^2/F0 [1], negative, from the pull-off force F0
/// of Z_c contacts and the mean force F_d and gap h of Z_d bridges without contact per grain:
///     Pcap = -(Phi/(pi a^2)) [Z_c F0 + Z_d F_d + Z_d <F h>_d/a]
/// Exact except for overlaps. s22cap differs from Pcap by at most 3 %, and by at most 2 % in most
/// states of Badetti et al. (2018). Source: eq:PcapvsFN.
double capillary_pressure(const State& state);

/// Estimate -Z* Phi/pi of the mean capillary stress a^2 Pcap/F0 [1], from the solid fraction Phi
/// and an effective coordination number Z* (`effective_coordination`). Neglects the term of the
/// gaps, <F h>_d, which Badetti et al. (2018) call negligible. Source: eq:cest1.
double capillary_pressure(double solid_fraction, double effective_coordination);

/// Shear stress of the capillary forces between pairs in contact, a^2 s12cap,c/F0 = -(3/pi) Z_c Phi
/// F12c [1], with Z_c contacts per grain, solid fraction Phi and fabric F12c (mean of n1 n2 over
/// contacts with direction n). Positive in steady shear. Exact except for overlaps. Source:
/// eq:s12capcdecomp.
double contact_capillary_shear_stress(const State& state);

/// Shear stress of bridges without contact, over F0/a^2 [1], negative in steady shear:
///     a^2 s12cap,d/F0 = -(3/pi) Phi Z_d (F_d/F0) (l0/a) [F12d + force + length anisotropy]
/// The formula is of first order in the anisotropies; Badetti et al. (2018) call it "quite
/// accurate". The next order, -15 F12d^2 x (force anisotropy) in the bracket, is not small, since
/// bridges are most frequent in directions where their force is small. Simulations at kappa 1000
/// gave magnitudes 3 to 9 % larger than the formula, the largest difference at high friction.
/// Source: eq:s12capddecomp.
double distant_capillary_shear_stress(const State& state);

/// Shear stress of all capillary forces, of contacts and of bridges without contact, a^2 s12cap/F0
/// [1], without the length anisotropy:
///     -(3/pi) Phi [Z_c F12c + (l0/a) Z_d (F_d/F0) (F12d + force anisotropy)]
/// Badetti et al. (2018) call the agreement "very good", on a scale from 0 to 0.1. At large liquid
/// content the contributions of contacts and distant bridges nearly cancel, so that relative errors
/// are large and absolute errors are the better measure. Simulations at kappa 1000 gave values
/// smaller than the formula by 0.001 to 0.011. Source: eq:estfinals12c.
double capillary_shear_stress(const State& state);

}  // namespace pendular::closures
