#pragma once

#include <optional>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"

namespace pendular {

/// Condition that is truly imposed on the grains if effects act, with the properties of grains and
/// liquid as effects change them. Without effects it equals the stated condition.
struct EffectiveCondition : Condition {
    EffectiveCondition() = default;
    EffectiveCondition(const Condition& imposed) : Condition(imposed) {}

    /// Properties of the liquid as effects change them; empty: the study's liquid.
    std::optional<Liquid> liquid;
    /// Friction coefficient between grains minus the friction coefficient of the study's model [1].
    double friction_difference = 0;
    /// Effects on grains that a simulation of the condition must contain, with parameter values in
    /// SI units.
    std::vector<EffectValues> grain_effects;

    bool operator==(const EffectiveCondition&) const = default;
};

/// Returns each condition in the form of an `EffectiveCondition` on which no effect acts, in the
/// same order: the study's liquid and friction, and no effects on grains.
inline std::vector<EffectiveCondition> without_effects(const std::vector<Condition>& conditions) {
    return {conditions.begin(), conditions.end()};
}

}  // namespace pendular
