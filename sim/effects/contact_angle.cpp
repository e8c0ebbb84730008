#include "sim/catalogue/effect.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pendular {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

/// The liquid wets the beads less well than the study states: a bridge attracts with pi a Gamma
/// cos(theta). The sum of the study's angle and the effect's angle is limited to 0 to 89 degrees,
/// since bridges do not attract above 90 degrees and a negative sum has no meaning. A negative
/// value of the effect's angle is useful where the study's angle is too large.
Effect contact_angle() {
    return {
        .summary = "the contact angle of the liquid differs from the value in study.toml",
        .equation = "F0 = pi a Gamma cos(theta + angle),  theta + angle limited to 0 to 89 degrees",
        .parameters = {{.name = "angle",
                        .unit = "rad",
                        .lower = -89 * degree,
                        .upper = 89 * degree,
                        .neutral = 0,
                        // Chosen: reduces the attraction of a perfectly wetting liquid by 1.5 %.
                        .smallest_of_interest = 10 * degree,
                        .meaning = "deviation of the contact angle from that in study.toml "
                                   "(without a study: from 0)",
                        .amplitude = [](double angle) { return 1 - std::cos(angle); }}},
        .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
            double& angle = condition.liquid->contact_angle;
            if (v["angle"] != 0) angle = std::clamp(angle + v["angle"], 0.0, 89 * degree);
            return condition;
        }},
        .touches = Touches::wet,
        .acts_through = {"1/reduced_pressure"},
        .directly =
            "the contact angle of a drop on the material of the grains, minus the angle in "
            "study.toml",
        .references = {
            "de Gennes, Brochard-Wyart and Quere, Capillarity and Wetting Phenomena (2004)",
            "Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
            "macroscopic cohesion and effective stress (2018), Eq. (5)"}};
}

}  // namespace pendular
