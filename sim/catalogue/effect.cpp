#include "sim/catalogue/effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "data/annular_cell.h"
#include "data/effect_parameter.h"
#include "data/grains.h"
#include "data/input_error.h"

namespace pendular {

double CellState::area() const {
    return std::numbers::pi * (outer_radius * outer_radius - inner_radius * inner_radius);
}

double CellState::torque_of(double shear_stress) const {
    const AnnularCell cell{.inner_radius = inner_radius, .outer_radius = outer_radius};
    return pendular::torque(shear_stress, cell);
}

double CellState::weight() const {
    return bead_volume * density * gravity;
}

namespace {

/// Returns the index of the entry with this name.
/// @throws std::invalid_argument where there is none, naming the nearest known name
template <typename Named>
std::size_t place_of(const std::vector<Named>& all, std::string_view name, const char* kind) {
    const auto found = std::ranges::find(all, name, &Named::name);
    if (found == all.end()) {
        std::vector<std::string> names;
        std::ranges::transform(all, std::back_inserter(names), &Named::name);
        throw std::invalid_argument(
            fmt::format("unknown {} '{}'; {}", kind, name, did_you_mean(name, names)));
    }
    return static_cast<std::size_t>(found - all.begin());
}

/// Returns the SI value of the unit that a run uses for quantities with this SI unit.
double run_unit(const std::string& unit, double normal_stress, const GrainProperties& grains) {
    const double diameter = grains.diameter;
    if (unit == "N") {
        return diameter * diameter * normal_stress;
    }
    if (unit == "Pa s") {
        return std::sqrt(grains.mass() * normal_stress / diameter);
    }
    return 1;  // effects on grains have no other units than these and pure numbers
}

}  // namespace

bool Effect::of_table() const {
    return of_instrument() &&
           std::get<ChangeInstrument>(change).where == ChangeInstrument::Where::table;
}

bool Effect::of_grains() const {
    return std::holds_alternative<dem::ChangePairs>(change) ||
           std::holds_alternative<dem::ChangeSample>(change);
}

bool Effect::is_switch() const {
    return std::ranges::all_of(parameters, &EffectParameter::is_switch);
}

std::vector<double> Effect::neutral() const {
    std::vector<double> values;
    std::ranges::transform(parameters, std::back_inserter(values), &EffectParameter::neutral);
    return values;
}

std::size_t Effect::parameter(std::string_view parameter_name) const {
    return place_of(parameters, parameter_name, fmt::format("parameter of {}", name).c_str());
}

std::string to_string(const ActiveEffect& active) {
    std::string text;
    for (std::size_t k = 0; k < active.values.size(); ++k) {
        const EffectParameter& parameter = active.effect->parameters[k];
        text += fmt::format("{}{} {}", k > 0 ? ", " : "", parameter.name,
                            printed_value(active.values[k], parameter));
    }
    return fmt::format("{} ({})", active.effect->name, text);
}

bool touches(const Effect& effect, const Condition& condition) {
    switch (effect.touches) {
        case Touches::dry:
            return condition.dry();
        case Touches::wet:
            return !condition.dry();
        case Touches::failure:
            return condition.at_failure;
        default:
            return true;
    }
}

std::vector<ActiveEffect> touching(const std::vector<ActiveEffect>& effects,
                                   const Condition& condition) {
    std::vector<ActiveEffect> result;
    std::ranges::copy_if(effects, std::back_inserter(result), [&](const ActiveEffect& active) {
        return touches(*active.effect, condition);
    });
    return result;
}

EffectiveCondition changed_condition(EffectiveCondition condition,
                                     const std::vector<ActiveEffect>& effects,
                                     const std::optional<Liquid>& liquid) {
    for (const ActiveEffect& active : touching(effects, condition)) {
        if (const auto* change = std::get_if<ChangeCondition>(&active.effect->change)) {
            if (!condition.dry() && !condition.liquid) condition.liquid = liquid;
            condition = change->change(std::move(condition), active.by_name());
        } else if (active.effect->of_grains()) {
            condition.grain_effects.push_back({active.effect->name, active.values});
        }
    }
    std::ranges::sort(condition.grain_effects, {}, &EffectValues::effect);
    return condition;
}

double Effect::unlisted_value(const std::optional<Liquid>& liquid) const {
    return given_by_liquid && liquid ? (*liquid).*given_by_liquid : parameters.front().neutral;
}

const Effect& effect_named(const std::vector<Effect>& effects, std::string_view name) {
    return effects[place_of(effects, name, "effect")];
}

const Effect& built_in_effect(std::string_view name) {
    return effect_named(built_in_effects(), name);
}

EffectValues in_run_units(const EffectValues& values, double normal_stress,
                          const GrainProperties& grains) {
    EffectValues result = values;
    const Effect& effect = built_in_effect(values.effect);
    for (std::size_t k = 0; k < result.values.size(); ++k) {
        result.values[k] /= run_unit(effect.parameters[k].unit, normal_stress, grains);
    }
    return result;
}

}  // namespace pendular
