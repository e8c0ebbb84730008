#pragma once

#include "sim/closures/state.h"

// Shear strength and cohesion of wet grains from the stress ratio mu*_0 of dry grains at the same
// friction and inertial number. All formulas assume effective stress: capillary forces load the
// contact network as external stresses would. Source of all equations: Badetti et al. (2018).
namespace pendular::closures {

/// Stress ratio of the contact forces alone [1], from the total stress ratio |s12|/s22:
///     |s12 - s12cap| / (s22 - s22cap)
/// If capillary forces load the contacts as external stresses would, it equals the stress ratio
/// mu*_0 of dry grains. It differs from mu*_0 by 5 to 10 % at the smallest reduced pressure P*
/// (0.5) for small friction and large bridges, and by less elsewhere. Source: eq:coulombeff.
double contact_stress_ratio(double stress_ratio, const CapillaryStress& capillary,
                            double reduced_pressure);

/// Stress ratio mu* of wet grains [1] from their capillary stresses and the stress ratio mu*_0 of
/// dry grains at the same friction and inertial number:
///     mu* = mu*_0 (1 - s22cap/s22) - s12cap/s22
/// Accuracy: see contact_stress_ratio. Source: eq:strength1.
double stress_ratio_from_stresses(double dry_stress_ratio, const CapillaryStress& capillary,
                                  double reduced_pressure);

/// Reduced cohesion of wet grains c* = a^2 c/F0 = mu*_0 Phi Z*/pi [1], from the stress ratio mu*_0
/// of dry grains; it neglects the capillary shear stress. Accurate at liquid contents of 0.03 and
/// above (friction 0.09), too high below. Source: eq:cohesion3.
double reduced_cohesion(double dry_stress_ratio, double solid_fraction,
                        double effective_coordination);

/// Rumpf's cohesion of wet grains c = mu*_0 Z Phi F0/(pi a^2) [Pa], from the stress ratio mu*_0 of
/// dry grains, a solid fraction Phi, a coordination number Z, a pull-off force F0 [N] and a grain
/// diameter a [m]. Accuracy: see reduced_cohesion. Source: eq:Rumpf.
double rumpf_cohesion(double dry_stress_ratio, double solid_fraction, double coordination,
                      double pull_off_force, double diameter);

/// Generalised reduced cohesion c*_g of wet grains [1], in units of F0/a^2, which includes the
/// capillary shear stress:
///     c*_g = mu*_0 Phi Z*/pi - a^2 s12cap/F0
/// It depends on the reduced pressure through its arguments. Satisfactory at small liquid contents,
/// where reduced_cohesion fails; as accurate as reduced_cohesion elsewhere. Source: eq:cohgen.
double generalised_cohesion(double dry_stress_ratio, double solid_fraction,
                            double effective_coordination, double capillary_shear_stress);

/// Stress ratio mu* of wet grains [1] from the stress ratio mu*_0 of dry grains, a reduced cohesion
/// c* and the reduced pressure P* = a^2 s22/F0:
///     mu* = mu*_0 + c*/P*
/// With c* from generalised_cohesion this is eq:strength2, accurate for all P* >= 0.5. With c* from
/// reduced_cohesion it is eq:strength3, too high by up to 20 to 30 %, most at small liquid content.
/// With c* from a straight-line (Mohr-Coulomb) fit it is eq:mohrcoulomb2, too high for P* <= 1.
/// Source: eq:strength2, eq:strength3, eq:mohrcoulomb2.
double stress_ratio_from_cohesion(double dry_stress_ratio, double reduced_cohesion,
                                  double reduced_pressure);

}  // namespace pendular::closures
