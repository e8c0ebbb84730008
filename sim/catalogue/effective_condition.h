#pragma once

#include <optional>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"

namespace pendular {

/// Condition that is truly imposed on the grains, with the properties of grains and liquid after
/// all effects on them. Without effects, it equals the condition that the study states.
struct EffectiveCondition : Condition {
    EffectiveCondition() = default;
    EffectiveCondition(const Condition& imposed) : Condition(imposed) {}

    std::optional<Liquid> liquid;    ///< after effects; empty: the liquid of the study
    double friction_difference = 0;  ///< friction coefficient minus that of the study's model [1]
    std::vector<EffectValues> grain_effects;  ///< those a simulation must contain, in SI units

    bool operator==(const EffectiveCondition&) const = default;
};

/// Returns conditions on which no effect acts, in the order of `conditions`.
inline std::vector<EffectiveCondition> without_effects(const std::vector<Condition>& conditions) {
    return {conditions.begin(), conditions.end()};
}

}  // namespace pendular
