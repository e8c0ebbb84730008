#pragma once

#include "sim/closures/state.h"

// Capillary and mean stresses from the networks that carry them. Everything here follows from
//     s_ab = (1/volume) sum over pairs of F_a r_b,   pairs per volume = 3 Phi Z/(pi a^3)
// for Z pairs per grain counted from both sides. Source of all equations: Badetti et al. (2018).
namespace pendular::closures {

/// F_d/F0 [1] as Badetti et al. (2018) takes it where it is not measured; it found 0.48 to 0.6 for
/// P* >= 2.
constexpr double usual_distant_force = 0.5;

/// Effective coordination Z* = Z_c + Z_d F_d/F0 [1]: bridges of force F0 per grain that attract as
/// much as those of the state. Source: eq:defzstar.
double effective_coordination(const State& state);

/// Z* = Z_c + 0.5 Z_d [1], shortcut of Badetti et al. (2018) for a distant force that is not known.
double approximate_coordination(const State& state);

/// Mean stress tr(s)/3 over s22 [1] from the mean normal forces:
///     P = (Phi/(pi a^2)) [Z <F_N> + Z_d <F h>_d/a],   Z <F_N> = Z_c (F_contact - F0) - Z_d F_d
/// Viscous and kinetic parts are not in it, nor the overlaps of contacts, by which their centres
/// are closer than a. Badetti et al. (2018) states no accuracy but that <F h>_d adds 2 % at most.
/// Source: eq:PvsFN.
double mean_stress(const State& state);

/// Mean capillary stress a^2 Pcap/F0 [1], below 0:
///     Pcap = -(Phi/(pi a^2)) [Z_c F0 + Z_d F_d + Z_d <F h>_d/a]
/// Exact but for overlaps. s22cap is within 3 % of it, in most of Badetti et al.'s states within 2
/// %. Source: eq:PcapvsFN.
double capillary_pressure(const State& state);

/// Estimate of a^2 Pcap/F0 [1] without the gaps, -Z* Phi/pi, for a coordination Z* of the caller's
/// choice. Badetti et al. (2018) calls what it leaves out negligible. Source: eq:cest1.
double capillary_pressure(double solid_fraction, double effective_coordination);

/// Shear stress of bridges in contact a^2 s12cap,c/F0 = -(3/pi) Z_c Phi F12c [1], above 0 in shear.
/// Exact but for overlaps. Source: eq:s12capcdecomp.
double contact_capillary_shear_stress(const State& state);

/// Shear stress of bridges without contact [1], below 0 in shear:
///     a^2 s12cap,d/F0 = -(3/pi) Phi Z_d (F_d/F0) (l0/a) [F12d + force + length anisotropy]
/// "Quite accurate" (Badetti et al. (2018)). It is first order in the anisotropies. Since F_d
/// weights directions by their bridges and these are many where the force is small, the next order,
/// -15 F12d^2 x (force anisotropy) in the bracket, is not small: simulations at kappa 1000 gave 3
/// to 9 % more than the closure, most with high friction. Source: eq:s12capddecomp.
double distant_capillary_shear_stress(const State& state);

/// Capillary shear stress a^2 s12cap/F0 [1], both parts, without the length anisotropy:
///     -(3/pi) Phi [Z_c F12c + (l0/a) Z_d (F_d/F0) (F12d + force anisotropy)]
/// "Very good" (Badetti et al. (2018), on a scale from 0 to 0.1). The parts nearly cancel at large
/// liquid content, so the error of the distant one then is a large share of the sum: judge it by
/// the difference. Simulations at kappa 1000 gave 0.001 to 0.011 less than the closure. Source:
/// eq:estfinals12c.
double capillary_shear_stress(const State& state);

}  // namespace pendular::closures
