#pragma once

#include <optional>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"

namespace pendular {

/// Condition that is truly imposed on the grains, with the properties of grains and liquid after
/// all effects on them are applied. Without effects, it equals the condition that the study states.
struct EffectiveCondition : Condition {
    EffectiveCondition() = default;
    EffectiveCondition(const Condition& imposed) : Condition(imposed) {}

    /// Properties of the liquid after effects are applied; empty: the properties of the study's
    /// liquid.
    std::optional<Liquid> liquid;
    /// Friction coefficient between grains minus the friction coefficient of the study's model [1].
    double friction_difference = 0;
    /// Effects on grains that a simulation of the condition must contain, with parameter values in
    /// SI units.
    std::vector<EffectValues> grain_effects;

    bool operator==(const EffectiveCondition&) const = default;
};

/// Converts conditions to effective conditions on which no effects act, with the liquid and
/// friction of the study, and returns them in the same order.
inline std::vector<EffectiveCondition> without_effects(const std::vector<Condition>& conditions) {
    return {conditions.begin(), conditions.end()};
}

}  // namespace pendular
