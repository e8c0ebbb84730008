#include "sim/catalogue/effect.h"

namespace pendular {

/// Liquid in the pendular regime: bridges pull grains together with forces proportional to the
/// surface tension. The effect is on in every study with a liquid, at the surface tension of the
/// liquid. Without surface tension, wet beads behave like dry beads.
Effect capillary_bridges() {
    return {.summary = "the surface tension of the liquid differs from the value in study.toml",
            .equation = "F0 = pi a Gamma cos(theta)      Gamma = surface_tension",
            .parameters = {{.name = "surface_tension",
                            .unit = "N/m",
                            .lower = 0,
                            .upper = 0.5,
                            .neutral = 0,
                            // Chosen: 5 % of the tension of silicone oil, 20.6 mN/m.
                            .smallest_of_interest = 1e-3,
                            .meaning = "surface tension of the liquid"}},
            .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
                condition.liquid->surface_tension = v["surface_tension"];
                if (v["surface_tension"] == 0) condition.liquid_content = 0;
                return condition;
            }},
            .touches = Touches::wet,
            .given_by_liquid = &Liquid::surface_tension,
            .acts_through = {"1/reduced_pressure", "liquid_content"},
            .directly = "a tensiometer",
            .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular "
                           "materials: macroscopic cohesion and effective stress (2018)",
                           "Maugis, J. Adhesion Sci. Technol. 1 (1987) 105: adherence of spheres "
                           "joined by a liquid bridge"}};
}

}  // namespace pendular
