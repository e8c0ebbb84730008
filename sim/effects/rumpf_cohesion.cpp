#include "sim/catalogue/effect.h"

namespace pendular {

/// Replaces the constant cohesions of base `mohr-coulomb`, which are fitted to readings, by Rumpf's
/// cohesion. Rumpf's cohesion follows from the simulated structure and varies with the reduced
/// pressure; it has no parameter.
Effect rumpf_cohesion() {
    return {
        .summary =
            "replaces fitted cohesions by Rumpf's cohesion from the structure (base mohr-coulomb)",
        .equation =
            "mu* = mu*_0 [1 + Phi_S Z/(pi P*)], Z = Z_c + 0.5 Z_d      eq:cohesion3 in place of "
            "eq:mohrcoulomb2",
        .parameters = {on_switch("0: eq:mohrcoulomb2, 1: eq:cohesion3")},
        .change = ChangeClosure{.level = closures::Level::rumpf},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {
            "Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
            "macroscopic cohesion and effective stress (2018), eq:Rumpf and eq:cohesion3"}};
}

}  // namespace pendular
