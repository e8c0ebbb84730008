#include "sim/catalogue/effect.h"

namespace pendular {

/// Capillary forces carry a shear stress opposite in sign to the total shear stress, which Rumpf's
/// cohesion neglects. The effect takes this shear stress into account.
Effect capillary_shear_stress() {
    return {
        .summary =
            "the formula of the strength includes the shear stress of the capillary forces, which "
            "Rumpf's formula neglects",
        .equation =
            "mu* = mu*_0 + (mu*_0 Phi_S Z*/pi - a^2 s12cap/F0)/P*      s12cap = 0 without the "
            "effect",
        .parameters = {on_switch("the capillary shear stress is included instead of neglected")},
        .change = ChangeClosure{.level = closures::Level::strength2},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
                       "macroscopic cohesion and effective stress (2018), Eqs. (22) and (23)"}};
}

}  // namespace pendular
