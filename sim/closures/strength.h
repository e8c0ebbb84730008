#pragma once

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

}  // namespace pendular::closures
