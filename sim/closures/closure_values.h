#pragma once

#include "sim/closures/state.h"

namespace pendular::closures {

/// Values that the closures (analytical formulas) of Badetti et al. (2018) give for one state of
/// wet grains. All are dimensionless; F0 is the pull-off force, a the grain diameter.
struct ClosureValues {
    /// Stress ratio mu*_0 of dry grains at the same friction and inertial number.
    double dry_stress_ratio = 0;
    double contact_stress_ratio = 0;  ///< stress ratio of the contact forces alone (eq:coulombeff)
    double effective_coordination = 0;    ///< Z* = Z_c + Z_d F_d/F0 (eq:defzstar)
    double approximate_coordination = 0;  ///< Z_c + 0.5 Z_d
    double rumpf_cohesion = 0;        ///< a^2 c/F0 with the approximate coordination (eq:cohesion3)
    double generalised_cohesion = 0;  ///< a^2 c/F0 with the capillary shear stress (eq:cohgen)
    double strength1 = 0;   ///< stress ratio from the measured capillary stresses (eq:strength1)
    double strength2 = 0;   ///< stress ratio from Z* and the capillary shear stress (eq:strength2)
    double strength3 = 0;   ///< stress ratio from Z* alone (eq:strength3)
    double saturation = 0;  ///< share of the pores that liquid fills, Phi_L/(1 - Phi_S)
};

/// Returns the values of all closures for one state.
/// @param capillary capillary stresses of the state over F0/a^2 [1]
/// @param stress_ratio stress ratio of the state [1]
/// @param dry_stress_ratio stress ratio of dry grains at the same friction and inertial number [1]
/// @param liquid_content liquid volume over grain volume [1]
ClosureValues closure_values(const State& state, const CapillaryStress& capillary,
                             double stress_ratio, double dry_stress_ratio, double liquid_content);

}  // namespace pendular::closures
