#pragma once

#include <limits>

#include "sim/dem/run.h"

// Capillary stresses and mean stress from averages over contacts and bridges. All formulas follow
// from the stress as a sum over pairs of grains, with F the force on the second grain of a pair and
// r the vector from the first to the second centre:
//     s_ab = (1/volume) sum of F_a r_b,   number of pairs per volume = 3 Phi Z/(pi a^3)
//
// Symbols: Phi solid fraction, a grain diameter, s22 normal stress along the velocity gradient, F0
// pull-off force; Z_c contacts per grain, F_c mean elastic force and F12c fabric (mean of n1 n2,
// with n the contact normal) of contacts. Distant bridges join grains that do not touch: Z_d per
// grain, F_d mean attraction, l0 mean distance of the centres, <F h>_d mean product of attraction
// and gap, F12d fabric, A_force and A_length anisotropies 12 of attraction and distance. Each pair
// counts for both of its grains. Compression is positive; bridges pull, so Pcap < 0.
//
// Source of all equations: Badetti et al. (2018).

namespace pendular::closures {

/// Averages [1] of a state of steady shear, from which the closures compute stresses. The
/// anisotropy 12 of a quantity q(n) is the integral of q n1 n2 over all directions, divided by 4 pi
/// and the mean of q; 1 is the flow and 2 the velocity gradient. A dry state has an infinite
/// reduced pressure and no distant pairs.
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

/// Stresses of the bridge forces [F0/a^2].
struct CapillaryStress {
    double normal = 0;  ///< along the velocity gradient; negative, since bridges attract
    double shear = 0;   ///< positive: lowers the magnitude of the total, negative shear stress
};

/// Returns the averages of a simulation run.
State network_state_of(const dem::RunResult& run);

/// Returns the stresses of the bridge forces that a run measured; zero for a dry run.
CapillaryStress capillary_stress_of(const dem::RunResult& run);

/// Mean force of distant bridges over the pull-off force [1] where it is not measured, as assumed
/// by Badetti et al. (2018). At reduced pressures of 2 and above, they found 0.48 to 0.6.
constexpr double usual_distant_force = 0.5;

/// Returns the effective coordination number [1]: the number of bridges per grain that would exert
/// the total attraction if each had the pull-off force.
///     Z* = Z_c + Z_d F_d/F0
/// Source: Eq. (21).
double effective_coordination(const State& state);

/// Returns Z_c + Z_d/2 [1], the approximation of Z* for an unknown mean force of distant bridges.
double approximate_coordination(const State& state);

/// Returns the mean P of the three normal stresses over s22 [1].
///     P = (Phi/(pi a^2)) [Z_c (F_c - F0) - Z_d F_d - Z_d <F h>_d/a]
/// Viscous stress, kinetic stress and overlaps of contacts are neglected.
/// Source: Eq. (9).
double mean_stress(const State& state);

/// Returns the mean Pcap of the three normal stresses of the bridge forces, in units of F0/a^2 [1].
///     Pcap = -(Phi/(pi a^2)) [Z_c F0 + Z_d F_d + Z_d <F h>_d/a]
/// Overlaps of contacts are neglected. The capillary normal stress along the velocity gradient
/// differs from Pcap by at most 3 %.
/// Source: Eq. (10).
double capillary_pressure(const State& state);

/// Returns an estimate of Pcap in units of F0/a^2 [1] that neglects the gaps that bridges span.
///     a^2 Pcap/F0 = -Z* Phi/pi
/// Source: Eq. (20).
double capillary_pressure(double solid_fraction, double effective_coordination);

/// Returns the shear stress of the bridge forces between grains in contact, in units of F0/a^2 [1];
/// positive in steady shear. Overlaps of contacts are neglected.
///     a^2 s12cap,c/F0 = -(3/pi) Z_c Phi F12c
/// Source: Eq. (28).
double contact_capillary_shear_stress(const State& state);

/// Returns the shear stress of distant bridges in units of F0/a^2 [1]; negative in steady shear.
///     a^2 s12cap,d/F0 = -(3/pi) Phi Z_d (F_d/F0) (l0/a) [F12d + A_force + A_length]
/// The formula is of first order in the anisotropies. At a stiffness number of 1000, simulations
/// gave magnitudes 3 to 9 % larger.
/// Source: Eq. (30).
double distant_capillary_shear_stress(const State& state);

/// Returns the shear stress of all bridge forces in units of F0/a^2 [1]. The anisotropy of the
/// lengths of bridges is neglected.
///     a^2 s12cap/F0 = -(3/pi) Phi [Z_c F12c + (l0/a) Z_d (F_d/F0) (F12d + A_force)]
/// At a stiffness number of 1000, simulations gave values 0.001 to 0.011 smaller than the formula.
/// Source: Eq. (31).
double capillary_shear_stress(const State& state);

}  // namespace pendular::closures
