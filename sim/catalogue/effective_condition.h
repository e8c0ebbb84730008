#pragma once

#include <optional>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"

namespace pendular {

/// Condition that is truly imposed in the presence of effects, with the properties of grains and
/// liquid as effects change them. Without effects it equals the stated condition.
struct EffectiveCondition : Condition {
    EffectiveCondition() = default;
    EffectiveCondition(const Condition& imposed) : Condition(imposed) {}

    std::optional<Liquid> liquid;             ///< liquid as effects change it; none: the study's
    double friction_difference = 0;           ///< addition to the study's friction coefficient [1]
    std::vector<EffectValues> grain_effects;  ///< effects on grains to simulate; SI units

    bool operator==(const EffectiveCondition&) const = default;
};

/// Converts each condition to an EffectiveCondition on which no effect acts: the imposed values as
/// given, the study's own liquid and friction, and no effects on grains.
inline std::vector<EffectiveCondition> without_effects(const std::vector<Condition>& conditions) {
    return {conditions.begin(), conditions.end()};
}

}  // namespace pendular
