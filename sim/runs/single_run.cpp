#include "sim/runs/single_run.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace pendular {
namespace {

/// Returns the condition of a run, to which effects are applied. Its liquid content is approximate;
/// effects may only set it to 0.
EffectiveCondition condition_of(const dem::RunParameters& run, const RunScale& scale) {
    EffectiveCondition condition;
    condition.normal_stress = scale.normal_stress;
    condition.inertial_number = run.inertial_number;
    if (run.wetting) {
        condition.liquid_content =
            dem::liquid_content(run.wetting->bridge_volume, dem::typical_coordination);
        condition.liquid = scale.liquid;
    }
    return condition;
}

void demand_possible(const Effect& effect, bool wet) {
    if (const std::string why = why_not_in_run(effect); !why.empty()) {
        throw std::invalid_argument(fmt::format("{}: {}", effect.name, why));
    }
    if (effect.touches == Touches::wet && !wet) {
        throw std::invalid_argument(fmt::format(
            "{} acts on wet grains, and these are dry; add a reduced pressure", effect.name));
    }
    if (effect.touches == Touches::dry && wet) {
        throw std::invalid_argument(fmt::format(
            "{} acts on dry grains, and these are wet; remove the reduced pressure", effect.name));
    }
}

}  // namespace

RunScale RunScale::of(const dem::RunParameters& run) const {
    RunScale result = *this;
    if (run.wetting) {
        result.normal_stress = run.wetting->reduced_pressure * pull_off_force(grains, liquid) /
                               (grains.diameter * grains.diameter);
    }
    return result;
}

std::string why_not_in_run(const Effect& effect) {
    if (effect.of_instrument()) {
        return "it acts on what an instrument shows, and a single simulation has no instrument; "
               "'pendular virtual-lab' has one";
    }
    if (effect.of_closure()) {
        return "it changes the formula of the strength that base = \"mohr-coulomb\" or \"rumpf\" "
               "uses, and a simulation uses no such formula";
    }
    if (std::holds_alternative<ChangeFlow>(effect.change)) {
        return "it changes the predicted stress by a factor and is not part of a simulation";
    }
    return "";
}

bool needs_scale(const Effect& effect) {
    return std::ranges::any_of(effect.parameters, [](const EffectParameter& p) {
        return p.unit != "1" && p.unit != "rad";
    });
}

dem::RunParameters changed_run(dem::RunParameters run, const std::vector<ActiveEffect>& effects,
                               const RunScale& scale) {
    for (const ActiveEffect& active : effects) {
        demand_possible(*active.effect, run.wetting.has_value());
    }
    const RunScale own = scale.of(run);
    const EffectiveCondition condition =
        changed_condition(condition_of(run, own), effects, own.liquid);
    run.friction += condition.friction_difference;
    for (const EffectValues& values : condition.grain_effects) {
        run.effects.push_back(in_run_units(values, own.normal_stress, own.grains));
    }
    if (condition.dry()) {
        run.wetting.reset();
    } else {
        // The normal stress is unchanged; the ratio is exactly 1 where no effect changes the force.
        run.wetting->reduced_pressure *=
            pull_off_force(own.grains, own.liquid) / pull_off_force(own.grains, *condition.liquid);
    }
    return run;
}

}  // namespace pendular
