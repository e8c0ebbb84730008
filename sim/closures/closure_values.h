#pragma once

#include <array>

#include "sim/closures/state.h"

namespace pendular::closures {

/// Values of the closures (analytical formulas) of Badetti et al. (2018) for one state of wet
/// grains. All values are dimensionless.
struct ClosureValues {
    /// Stress ratio of dry grains at the same friction and inertial number.
    double dry_stress_ratio = 0;
    /// Ratio of shear stress to normal stress in wet grains, both from the contact forces alone,
    /// without the bridge forces (eq:coulombeff).
    double contact_stress_ratio = 0;
    /// Effective coordination number Z* = Z_c + Z_d F_d/F0 (eq:defzstar). Z_c: contacts per grain;
    /// Z_d: distant bridges per grain (bridges between grains that do not touch); F_d: mean force
    /// of distant bridges; F0: pull-off force.
    double effective_coordination = 0;
    /// Approximate effective coordination number: contacts per grain plus half the number per grain
    /// of bridges between grains that do not touch.
    double approximate_coordination = 0;
    /// Reduced cohesion a^2 c/F0 from the approximate coordination number (eq:cohesion3), with
    /// cohesion c, grain diameter a and pull-off force F0.
    double rumpf_cohesion = 0;
    /// Reduced cohesion a^2 c/F0 with the capillary shear stress included (eq:cohgen), with
    /// cohesion c, grain diameter a and pull-off force F0.
    double generalised_cohesion = 0;
    /// Stress ratio of wet grains computed from the measured capillary stresses (eq:strength1).
    double strength1 = 0;
    /// Stress ratio of wet grains from the effective coordination number and the capillary shear
    /// stress (eq:strength2).
    double strength2 = 0;
    /// Stress ratio of wet grains from the effective coordination number alone (eq:strength3).
    double strength3 = 0;
    double saturation = 0;  ///< share of the pore volume between the grains that liquid fills [1]
};

/// Name, text and axis label of a member of `ClosureValues`.
struct ClosureQuantity {
    const char* name;   ///< key of the closure's value in JSON and CSV
    const char* text;   ///< name of the closure's value in printed tables
    const char* label;  ///< label of the closure's value at an axis
    double ClosureValues::*value;
};

/// All members of `ClosureValues`, in the order in which they are printed.
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

/// Returns the values of all closures (analytical formulas) for one state of wet grains.
/// @param capillary capillary stresses of the state in units of F0/a^2 [1], with pull-off force F0
///         and grain diameter a
/// @param stress_ratio stress ratio of the state [1]
/// @param dry_stress_ratio stress ratio of dry grains at the same friction and inertial number [1]
/// @param liquid_content liquid volume divided by grain volume [1]
ClosureValues closure_values(const State& state, const CapillaryStress& capillary,
                             double stress_ratio, double dry_stress_ratio, double liquid_content);

/// Evaluates all closures (analytical formulas for strength, cohesion and coordination) with the
/// structure and stresses of a simulation of wet grains, averaged over the simulation.
/// @param dry_stress_ratio stress ratio of dry grains at the same friction and inertial number [1]
ClosureValues closure_values(const dem::RunResult& run, double dry_stress_ratio);

}  // namespace pendular::closures
