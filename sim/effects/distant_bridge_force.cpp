#include "sim/catalogue/effect.h"

namespace pendular {

/// Weighs bridges without contact by their simulated mean force. Rumpf's cohesion, as Badetti et
/// al. (2018) use it, assumes half the pull-off force F0 for each.
Effect distant_bridge_force() {
    return {
        .summary =
            "in Rumpf's formula, bridges between separated grains have the simulated mean force "
            "instead of half the pull-off force F0",
        .equation =
            "mu* = mu*_0 [1 + Phi_S Z*/(pi P*)], Z* = Z_c + Z_d F_d/F0      in place of Z_c + 0.5 "
            "Z_d",
        .parameters = {on_switch("simulated mean force F_d of bridges between separated grains, "
                                 "instead of half the pull-off force F0")},
        .change = ChangeClosure{.level = closures::Level::strength3},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
                       "macroscopic cohesion and effective stress (2018), Eqs. (21) and (23)"}};
}

}  // namespace pendular
