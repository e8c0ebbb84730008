#include "sim/catalogue/effect.h"

namespace pendular {

/// Takes the capillary normal stress itself in place of its estimate by the effective coordination
/// number, which neglects the gaps of bridges and normal stress differences.
Effect capillary_normal_stress() {
    return {
        .summary =
            "the formula of the strength uses the simulated capillary normal stress, instead of "
            "estimating it from the effective coordination number Z*",
        .equation =
            "mu* = mu*_0 (1 - s22cap/s22) - s12cap/s22      in place of mu* = mu*_0 + (mu*_0 Phi_S "
            "Z*/pi - a^2 s12cap/F0)/P*",
        .parameters = {on_switch(
            "simulated capillary normal stress instead of its estimate by Z*")},
        .change = ChangeClosure{.level = closures::Level::strength1},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
                       "macroscopic cohesion and effective stress (2018), Eqs. (18) and (19)"}};
}

}  // namespace pendular
