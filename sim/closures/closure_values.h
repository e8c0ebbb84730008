#pragma once

#include <array>

#include "sim/closures/state.h"

// Stress ratio and cohesion of wet grains from the stress ratio mu*_0 of dry grains that have their
// friction coefficient and inertial number. All formulas assume effective stress: capillary forces
// load the network of contacts as external stresses do. Phi is the solid fraction, Z* the effective
// coordination number, P* the reduced pressure, F0 the pull-off force, a the grain diameter; s12
// and s22 are shear and normal stress, s12cap and s22cap those of the bridge forces.
//
// Source of all equations: Badetti et al. (2018).

namespace pendular::closures {

/// Returns the stress ratio of the contact forces alone [1].
///     |s12 - s12cap| / (s22 - s22cap)
/// In simulations at P* >= 0.5, it differed from mu*_0 by at most 10 %.
/// @param stress_ratio of the wet grains [1]
/// Source: Eq. (18).
double contact_stress_ratio(double stress_ratio, const CapillaryStress& capillary,
                            double reduced_pressure);

/// Returns the stress ratio mu* of wet grains [1].
///     mu* = mu*_0 (1 - s22cap/s22) - s12cap/s22
/// At P* >= 0.5, mu* differed from simulations by at most 13 %.
/// Source: Eq. (19).
double stress_ratio_from_stresses(double dry_stress_ratio, const CapillaryStress& capillary,
                                  double reduced_pressure);

/// Returns the reduced cohesion c* = a^2 c/F0 of wet grains [1] without the capillary shear stress.
///     c* = mu*_0 Phi Z*/pi
/// At a friction coefficient of 0.09, the formula is accurate for liquid contents of 0.03 and
/// above, and overestimates the cohesion below.
/// Source: Eq. (24).
double reduced_cohesion(double dry_stress_ratio, double solid_fraction,
                        double effective_coordination);

/// Returns the cohesion c of wet grains [Pa] by Rumpf's formula, with the limits of
/// `reduced_cohesion`.
///     c = mu*_0 Z Phi F0/(pi a^2)
/// @param coordination number Z [1]
/// @param pull_off_force [N]
/// @param diameter of the grains [m]
/// Source: Eq. (2).
double rumpf_cohesion(double dry_stress_ratio, double solid_fraction, double coordination,
                      double pull_off_force, double diameter);

/// Returns the reduced cohesion of wet grains [1] with the capillary shear stress.
///     c*_g = mu*_0 Phi Z*/pi - a^2 s12cap/F0
/// In contrast to `reduced_cohesion`, the formula is satisfactory at small liquid contents too.
/// @param capillary_shear_stress s12cap in units of F0/a^2 [1]
/// Source: Eq. (25).
double generalised_cohesion(double dry_stress_ratio, double solid_fraction,
                            double effective_coordination, double capillary_shear_stress);

/// Returns the stress ratio mu* of wet grains [1] from a reduced cohesion c*.
///     mu* = mu*_0 + c*/P*
/// With c* from `generalised_cohesion` (Eq. 22), mu* differed from simulations by at most 13 % for
/// P* >= 0.5. With c* from `reduced_cohesion` (Eq. 23), mu* was too high by up to 37 %. With c*
/// from a straight-line (Mohr-Coulomb) fit (Eq. 16), mu* is too high for P* <= 1.
double stress_ratio_from_cohesion(double dry_stress_ratio, double reduced_cohesion,
                                  double reduced_pressure);

/// Values [1] of the closures of Badetti et al. (2018), whose equations the numbers name, for one
/// state of wet grains. c is the cohesion, a the grain diameter, F0 the pull-off force.
struct ClosureValues {
    double dry_stress_ratio = 0;          ///< of dry grains of equal friction and inertial number
    double contact_stress_ratio = 0;      ///< of the contact forces alone, Eq. (18)
    double effective_coordination = 0;    ///< Z* = Z_c + Z_d F_d/F0, Eq. (21)
    double approximate_coordination = 0;  ///< Z_c + Z_d/2
    double rumpf_cohesion = 0;  ///< a^2 c/F0 from the approximate coordination number, Eq. (24)
    double generalised_cohesion = 0;  ///< a^2 c/F0 with the capillary shear stress, Eq. (25)
    double strength1 = 0;             ///< stress ratio from the capillary stresses, Eq. (19)
    double strength2 = 0;   ///< stress ratio from Z* and the capillary shear stress, Eq. (22)
    double strength3 = 0;   ///< stress ratio from Z* alone, Eq. (23)
    double saturation = 0;  ///< share of the pore volume that liquid fills
};

/// Member of `ClosureValues` with its names.
struct ClosureQuantity {
    const char* name;   ///< in JSON and CSV
    const char* text;   ///< in printed tables
    const char* label;  ///< on the axis of a figure
    double ClosureValues::*value;
};

/// All members of `ClosureValues` in the order in which they are printed.
inline constexpr std::array<ClosureQuantity, 10> closure_quantities = {{
    {"dry_stress_ratio", "stress ratio of dry grains, predicted", "stress ratio μ*_0 of dry grains",
     &ClosureValues::dry_stress_ratio},
    {"contact_stress_ratio", "stress ratio of the contact stresses alone",
     "stress ratio of contacts |σ_{12}^{cont}|/σ_{22}^{cont}",
     &ClosureValues::contact_stress_ratio},
    {"strength1", "stress ratio by Eq. (19), from capillary stresses s22cap, s12cap",
     "stress ratio from σ_{22}^{cap}, σ_{12}^{cap}", &ClosureValues::strength1},
    {"strength2", "stress ratio by Eq. (22), from Z* and s12cap",
     "stress ratio from Z*, σ_{12}^{cap}", &ClosureValues::strength2},
    {"strength3", "stress ratio by Eq. (23), from Z* alone", "stress ratio from Z*",
     &ClosureValues::strength3},
    {"effective_coordination", "Z* = Z_c + Z_d F_d/F0, computed from its parts", "Z_c + Z_dF_d/F_0",
     &ClosureValues::effective_coordination},
    {"approximate_coordination", "Z_c + 0.5 Z_d, an approximation of Z*", "Z_c + 0.5Z_d",
     &ClosureValues::approximate_coordination},
    {"rumpf_cohesion", "reduced cohesion by Eq. (24), Rumpf, Z_c + 0.5 Z_d",
     "reduced cohesion by Rumpf's formula", &ClosureValues::rumpf_cohesion},
    {"generalised_cohesion", "reduced cohesion by Eq. (25), Z* and s12cap",
     "generalised reduced cohesion", &ClosureValues::generalised_cohesion},
    {"saturation", "degree of saturation of the pores", "saturation of the pores",
     &ClosureValues::saturation},
}};

/// Returns the closures for one state of wet grains.
/// @param stress_ratio of the wet grains [1]
/// @param dry_stress_ratio stress ratio [1] of dry grains of equal friction coefficient and
///         inertial number
/// @param liquid_content liquid volume over grain volume [1]
ClosureValues closure_values(const State& state, const CapillaryStress& capillary,
                             double stress_ratio, double dry_stress_ratio, double liquid_content);

/// Returns the closures for the averages of a simulation of wet grains.
ClosureValues closure_values(const dem::RunResult& run, double dry_stress_ratio);

}  // namespace pendular::closures
