#pragma once

#include <optional>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"

namespace pendular {

/// A condition as effects make it: what is truly imposed, and which grains and liquid it is imposed
/// on. Without effects it is the condition itself.
struct EffectiveCondition : Condition {
    EffectiveCondition() = default;
    EffectiveCondition(const Condition& imposed) : Condition(imposed) {}

    std::optional<Liquid> liquid;             ///< none: the study's
    double friction_difference = 0;           ///< to the friction of the study [1]
    std::vector<EffectValues> grain_effects;  ///< in SI units

    bool operator==(const EffectiveCondition&) const = default;
};

/// Conditions on which no effect acts.
inline std::vector<EffectiveCondition> without_effects(const std::vector<Condition>& conditions) {
    return {conditions.begin(), conditions.end()};
}

}  // namespace pendular
