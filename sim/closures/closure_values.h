#pragma once

#include <array>

#include "sim/closures/state.h"

namespace pendular::closures {

/// Dimensionless values of the closures (analytical formulas) of Badetti et al. (2018) for one
/// state of wet grains.
struct ClosureValues {
    /// Stress ratio of dry grains that have the friction coefficient and the inertial number of the
    /// wet grains.
    double dry_stress_ratio = 0;
    /// Stress ratio of the contact forces alone in wet grains: shear stress divided by normal
    /// stress, after the contributions of the bridge forces are subtracted from both.
    /// Source: Badetti et al. (2018), Eq. (18).
    double contact_stress_ratio = 0;
    /// Effective coordination number Z* = Z_c + Z_d F_d/F0. Z_c is the number of contacts per
    /// grain, Z_d the number of distant bridges per grain (bridges between grains that do not
    /// touch), F_d the mean force of distant bridges, and F0 the pull-off force.
    /// Source: Badetti et al. (2018), Eq. (21).
    double effective_coordination = 0;
    /// Approximate effective coordination number: contacts per grain plus half the number of
    /// bridges per grain between grains that do not touch.
    double approximate_coordination = 0;
    /// Reduced cohesion a^2 c/F0 from the approximate coordination number, with cohesion c, grain
    /// diameter a and pull-off force F0.
    /// Source: Badetti et al. (2018), Eq. (24).
    double rumpf_cohesion = 0;
    /// Reduced cohesion a^2 c/F0 with the capillary shear stress included, with cohesion c, grain
    /// diameter a and pull-off force F0.
    /// Source: Badetti et al. (2018), Eq. (25).
    double generalised_cohesion = 0;
    /// Stress ratio of wet grains, computed from the normal stress and the shear stress of the
    /// bridge forces and from the stress ratio of dry grains.
    /// Source: Badetti et al. (2018), Eq. (19).
    double strength1 = 0;
    /// Stress ratio of wet grains, computed from the effective coordination number, the shear
    /// stress of the bridge forces and the stress ratio of dry grains.
    /// Source: Badetti et al. (2018), Eq. (22).
    double strength2 = 0;
    /// Stress ratio of wet grains, computed from the effective coordination number and the stress
    /// ratio of dry grains. The shear stress of the bridge forces is neglected.
    /// Source: Badetti et al. (2018), Eq. (23).
    double strength3 = 0;
    double saturation = 0;  ///< share of the pore volume between the grains that liquid fills [1]
};

/// Key, name and axis label of one member of `ClosureValues` (values of analytical formulas for wet
/// grains), with a pointer to the member.
struct ClosureQuantity {
    const char* name;   ///< key of the value in JSON and CSV
    const char* text;   ///< name of the value in printed tables
    const char* label;  ///< label of the value on the axis of a figure
    double ClosureValues::*value;
};

/// Keys, names and axis labels of all members of `ClosureValues` (values of analytical formulas for
/// wet grains), in the order in which the members are printed.
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
/// @param capillary stresses of the bridge forces in units of F0/a^2 [1], with pull-off force F0
///         and grain diameter a
/// @param stress_ratio stress ratio of the wet grains [1]
/// @param dry_stress_ratio stress ratio [1] of dry grains that have the friction coefficient and
///         the inertial number of the wet grains
/// @param liquid_content liquid volume divided by grain volume [1]
ClosureValues closure_values(const State& state, const CapillaryStress& capillary,
                             double stress_ratio, double dry_stress_ratio, double liquid_content);

/// Returns the values of all closures (analytical formulas for strength, cohesion and coordination
/// number) for the averages of the observables in a simulation of wet grains.
/// @param dry_stress_ratio stress ratio [1] of dry grains that have the friction coefficient and
///         the inertial number of the wet grains
ClosureValues closure_values(const dem::RunResult& run, double dry_stress_ratio);

}  // namespace pendular::closures
