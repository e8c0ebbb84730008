#pragma once

#include "sim/closures/state.h"

// Shear strength and cohesion of wet grains from the dry stress ratio mu*_0 at the same friction
// and inertial number, by the idea of effective stress: capillary forces press the contact network
// as stresses from outside would. Source of all equations: Badetti et al. (2018).
namespace pendular::closures {

/// Stress ratio of the contact forces alone [1], which the idea says is that of dry grains:
///     |s12 - s12cap| / (s22 - s22cap)
/// from the total stress ratio |s12|/s22. Within 5 to 10 % of mu*_0 at the smallest P* (0.5), at
/// small friction and large bridges, better elsewhere. Source: eq:coulombeff.
double contact_stress_ratio(double stress_ratio, const CapillaryStress& capillary,
                            double reduced_pressure);

/// Stress ratio of wet grains [1] from their capillary stresses:
///     mu* = mu*_0 (1 - s22cap/s22) - s12cap/s22
/// Accurate as contact_stress_ratio is. Source: eq:strength1.
double stress_ratio_from_stresses(double dry_stress_ratio, const CapillaryStress& capillary,
                                  double reduced_pressure);

/// Reduced cohesion c* = a^2 c/F0 [1] without capillary shear stress: mu*_0 Phi Z*/pi. Right for
/// liquid contents of 0.03 and more (friction 0.09), too high below. Source: eq:cohesion3.
double reduced_cohesion(double dry_stress_ratio, double solid_fraction,
                        double effective_coordination);

/// Rumpf's cohesion c = mu*_0 Z Phi F0/(pi a^2) [Pa], from a pull-off force [N], a grain diameter
/// [m] and a coordination Z of the caller's choice; accurate as reduced_cohesion is. Source:
/// eq:Rumpf.
double rumpf_cohesion(double dry_stress_ratio, double solid_fraction, double coordination,
                      double pull_off_force, double diameter);

/// Generalised reduced cohesion c*_g [1], a function of P* through its arguments:
///     c*_g = mu*_0 Phi Z*/pi - a^2 s12cap/F0
/// Satisfactory where reduced_cohesion fails, at small liquid contents; no better elsewhere.
/// Source: eq:cohgen.
double generalised_cohesion(double dry_stress_ratio, double solid_fraction,
                            double effective_coordination, double capillary_shear_stress);

/// Stress ratio of wet grains [1] of a cohesion:
///     mu* = mu*_0 + c*/P*
/// With generalised_cohesion it is eq:strength2, good throughout 0.5 <= P*; with reduced_cohesion
/// eq:strength3, too high by up to 20 to 30 %, most at small liquid content; with the cohesion of a
/// straight line eq:mohrcoulomb2, too high for P* <= 1.
/// Source: eq:strength2, eq:strength3, eq:mohrcoulomb2.
double stress_ratio_from_cohesion(double dry_stress_ratio, double reduced_cohesion,
                                  double reduced_pressure);

}  // namespace pendular::closures
