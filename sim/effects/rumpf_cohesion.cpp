#include "sim/catalogue/effect.h"

namespace pendular {

/// Replaces the constant cohesions of base `mohr-coulomb`, which are fitted to readings, by Rumpf's
/// cohesion. Rumpf's cohesion follows from the simulated structure and varies with the reduced
/// pressure; it has no parameter.
Effect rumpf_cohesion() {
    return {
        .summary =
            "Rumpf's formula gives the cohesion from the simulated coordination numbers, instead "
            "of a fit to the wet readings",
        .equation =
            "mu* = mu*_0 [1 + Phi_S Z/(pi P*)], Z = Z_c + 0.5 Z_d      in place of mu* = mu*_0 + "
            "c*/P* with a fitted c*",
        .parameters = {on_switch(
            "cohesion by Rumpf's formula instead of cohesions fitted to the wet readings")},
        .change = ChangeClosure{.level = closures::Level::rumpf},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
                       "macroscopic cohesion and effective stress (2018), Eqs. (2) and (24)"}};
}

}  // namespace pendular
