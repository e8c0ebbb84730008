#pragma once

#include <optional>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"

namespace pendular {

/// Condition (normal stress, inertial number and liquid content) that is truly imposed on the
/// grains, with the properties of grains and liquid after all effects on these properties are
/// applied. Without effects, the condition equals the condition that the study states.
struct EffectiveCondition : Condition {
    EffectiveCondition() = default;
    EffectiveCondition(const Condition& imposed) : Condition(imposed) {}

    /// Properties of the liquid after effects are applied; empty if the liquid has the properties
    /// that the study states.
    std::optional<Liquid> liquid;
    /// Friction coefficient between grains minus the friction coefficient of the study's model [1].
    double friction_difference = 0;
    /// Effects on grains that a simulation of the condition must contain, with parameter values in
    /// SI units.
    std::vector<EffectValues> grain_effects;

    bool operator==(const EffectiveCondition&) const = default;
};

/// Returns the given conditions as effective conditions on which no effect acts, in the order of
/// `conditions`. The effective conditions have the liquid and the friction coefficient of the
/// study.
inline std::vector<EffectiveCondition> without_effects(const std::vector<Condition>& conditions) {
    return {conditions.begin(), conditions.end()};
}

}  // namespace pendular
