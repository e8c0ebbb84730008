#pragma once

#include <array>

#include "sim/closures/state.h"

namespace pendular::closures {

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
