#include "sim/catalogue/effect.h"

namespace pendular {

/// Takes the capillary normal stress itself in place of its estimate by the effective coordination
/// number, which neglects the gaps of bridges and normal stress differences.
Effect capillary_normal_stress() {
    return {
        .summary =
            "takes the capillary normal stress itself, not its estimate by Z* (not for base dem)",
        .equation =
            "mu* = mu*_0 (1 - s22cap/s22) - s12cap/s22      eq:strength1 in place of eq:strength2",
        .parameters = {on_switch("0: eq:strength2, 1: eq:strength1")},
        .change = ChangeClosure{.level = closures::Level::strength1},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure", "liquid_content"},
        .references = {
            "Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
            "macroscopic cohesion and effective stress (2018), eq:coulombeff and eq:strength1"}};
}

}  // namespace pendular
