#include "sim/catalogue/effect.h"

namespace pendular {

/// A liquid film lubricates surfaces, or makes them rougher where it swells or cleans them: the
/// friction of wet beads differs from that of dry beads.
Effect wet_friction() {
    return {
        .summary = "the friction coefficient of wet grains differs from that of dry grains",
        .equation = "mu_wet = mu + difference",
        .parameters = {{.name = "difference",
                        .unit = "1",
                        .lower = -0.5,
                        .upper = 0.5,
                        .neutral = 0,
                        // Chosen: about the error of a fitted friction (docs/validation.md).
                        .smallest_of_interest = 0.01,
                        .meaning = "friction coefficient of wet grains minus that of dry grains"}},
        .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
            condition.friction_difference += v["difference"];
            return condition;
        }},
        .touches = Touches::wet,
        .acts_through = {"liquid_content"},
        .references = {"Bowden and Tabor, The Friction and Lubrication of Solids (1950): "
                       "boundary lubrication"}};
}

}  // namespace pendular
