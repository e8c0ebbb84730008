#pragma once

#include "sim/closures/state.h"

// Stress ratio and cohesion of wet grains from the stress ratio of dry grains. The dry grains have
// the friction coefficient and the inertial number of the wet grains. All formulas assume effective
// stress: capillary forces load the network of contacts as external stresses do. Source of all
// equations: Badetti et al. (2018).
namespace pendular::closures {

/// Returns the stress ratio of the contact forces alone [1]: shear stress divided by normal stress,
/// after the capillary stresses are subtracted from both.
///     |s12 - s12cap| / (s22 - s22cap)      s12, s22: shear and normal stress, cap: capillary
/// In simulations at reduced pressures of 0.5 and above, the stress ratio of the contact forces
/// differed from the stress ratio of dry grains by at most 10 %.
/// @param stress_ratio total stress ratio of the wet grains [1]
/// Source: Badetti et al. (2018), Eq. (18).
double contact_stress_ratio(double stress_ratio, const CapillaryStress& capillary,
                            double reduced_pressure);

/// Returns the stress ratio mu* of wet grains [1] from the stress ratio mu*_0 of dry grains.
///     mu* = mu*_0 (1 - s22cap/s22) - s12cap/s22
/// s22 is the normal stress, s22cap the capillary normal stress, and s12cap the capillary shear
/// stress. At reduced pressures of 0.5 and above, mu* differed from simulations by at most 13 %.
/// @param dry_stress_ratio stress ratio mu*_0 [1] of dry grains that have the friction coefficient
///         and the inertial number of the wet grains
/// Source: Badetti et al. (2018), Eq. (19).
double stress_ratio_from_stresses(double dry_stress_ratio, const CapillaryStress& capillary,
                                  double reduced_pressure);

/// Returns the reduced cohesion c* = a^2 c/F0 of wet grains [1], with cohesion c, grain diameter a
/// and pull-off force F0. The formula neglects the capillary shear stress.
///     c* = mu*_0 Phi Z*/pi      mu*_0: stress ratio of dry grains, Phi: solid fraction,
///                               Z*: effective coordination number
/// At a friction coefficient of 0.09, the formula is accurate for liquid contents of 0.03 and
/// above. At smaller liquid contents, the formula overestimates the cohesion.
/// Source: Badetti et al. (2018), Eq. (24).
double reduced_cohesion(double dry_stress_ratio, double solid_fraction,
                        double effective_coordination);

/// Returns the cohesion c of wet grains [Pa] by Rumpf's formula.
///     c = mu*_0 Z Phi F0/(pi a^2)
/// mu*_0 is the stress ratio of dry grains [1], Z the coordination number [1], Phi the solid
/// fraction [1], F0 the pull-off force [N], and a the grain diameter [m]. At a friction coefficient
/// of 0.09, the formula is accurate for liquid contents of 0.03 and above. At smaller liquid
/// contents, the formula overestimates the cohesion.
/// Source: Badetti et al. (2018), Eq. (2).
double rumpf_cohesion(double dry_stress_ratio, double solid_fraction, double coordination,
                      double pull_off_force, double diameter);

/// Returns the reduced cohesion c*_g = a^2 c/F0 of wet grains [1], with cohesion c, grain diameter
/// a and pull-off force F0. The formula includes the capillary shear stress s12cap.
///     c*_g = mu*_0 Phi Z*/pi - a^2 s12cap/F0
/// mu*_0 is the stress ratio of dry grains, Phi the solid fraction, and Z* the effective
/// coordination number. In contrast to `reduced_cohesion`, the formula is satisfactory at small
/// liquid contents too.
/// @param capillary_shear_stress capillary shear stress s12cap in units of F0/a^2 [1]
/// Source: Badetti et al. (2018), Eq. (25).
double generalised_cohesion(double dry_stress_ratio, double solid_fraction,
                            double effective_coordination, double capillary_shear_stress);

/// Returns the stress ratio mu* of wet grains [1] from the stress ratio mu*_0 of dry grains, a
/// reduced cohesion c* and the reduced pressure P*.
///     mu* = mu*_0 + c*/P*
/// With c* from `generalised_cohesion` (Eq. 22), mu* differed from simulations by at most 13 % for
/// P* >= 0.5. With c* from `reduced_cohesion` (Eq. 23), mu* was too high by up to 37 %. With c*
/// from a straight-line (Mohr-Coulomb) fit (Eq. 16), mu* is too high for P* <= 1.
/// Source: Badetti et al. (2018), Eq. (22), Eq. (23), Eq. (16).
double stress_ratio_from_cohesion(double dry_stress_ratio, double reduced_cohesion,
                                  double reduced_pressure);

}  // namespace pendular::closures
