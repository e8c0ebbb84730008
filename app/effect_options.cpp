#include "app/effect_options.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "data/effect_parameter.h"
#include "data/input_error.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"

namespace pendular::app {
namespace {

std::string key(const Effect& effect, const EffectParameter& parameter) {
    return effect.name + "." + parameter.name;
}

std::string description(const Effect& effect, const EffectParameter& parameter) {
    if (parameter.is_switch()) return "1: " + parameter.meaning;
    const std::string text = parameter.meaning + "; " + printed_bounds(parameter);
    return effect.given_by_liquid
               ? text
               : text + ", no effect at " + printed_value(parameter.neutral, parameter);
}

/// Checks an argument of the form --EFFECT.PARAMETER; any other argument passes.
/// @throws InputError for an effect or parameter that does not exist, and for an effect that the
///         command cannot have
void check_name(const std::string& argument, const WhyNot& why_not) {
    const std::string name = argument.substr(0, argument.find('='));
    const std::size_t dot = name.find('.');
    if (!name.starts_with("--") || dot == std::string::npos) {
        return;
    }
    std::string reason;
    try {
        const Effect& effect = built_in_effect(name.substr(2, dot - 2));
        effect.parameter(name.substr(dot + 1));
        reason = why_not ? why_not(effect) : "";
    } catch (const std::invalid_argument& error) {
        reason = error.what();
    }
    if (!reason.empty()) {
        throw InputError(fmt::format("{}: {}", name, reason));
    }
}

double value_of(const std::string& words, const EffectParameter& parameter) {
    if (const auto number = parse_number(words)) {
        return *number;
    }
    return quantity_in_si(words, Unit(parameter.unit));
}

/// Value of a parameter in its unit, parsed from the text of an option.
/// @throws InputError for a text that is not a value of this parameter, and for a value out of
///         bounds
double checked_value(const std::string& words, const std::string& option,
                     const EffectParameter& parameter) {
    double value = 0;
    try {
        value = value_of(words, parameter);
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("--{}: {}", option, error.what()));
    }
    if (parameter.is_switch() && value != 0 && value != 1) {
        throw InputError(fmt::format("--{} {}: a switch is 0 or 1", option, words));
    }
    if (!(value >= parameter.lower && value <= parameter.upper)) {
        throw InputError(fmt::format("--{} {}: it must lie between {} and {}", option, words,
                                     printed_value(parameter.lower, parameter),
                                     printed_value(parameter.upper, parameter)));
    }
    return value;
}

}  // namespace

EffectOptions::EffectOptions(Options& options, const std::vector<std::string>& arguments,
                             const std::string& meaning, const WhyNot& why_not) {
    for (const std::string& argument : arguments) {
        check_name(argument, why_not);
    }
    options.begin_section(meaning);
    for (const Effect& effect : built_in_effects()) {
        if (why_not && !why_not(effect).empty()) {
            continue;
        }
        for (const EffectParameter& parameter : effect.parameters) {
            const std::string name = key(effect, parameter);
            options.add(name.c_str(), &words_[name], description(effect, parameter));
        }
    }
}

std::vector<ActiveEffect> EffectOptions::effects() const {
    std::vector<ActiveEffect> result;
    for (const Effect& effect : built_in_effects()) {
        ActiveEffect active{&effect, effect.neutral()};
        bool given = false;
        for (std::size_t k = 0; k < effect.parameters.size(); ++k) {
            const std::string name = key(effect, effect.parameters[k]);
            if (const auto words = words_.find(name);
                words != words_.end() && !words->second.empty()) {
                active.values[k] = checked_value(words->second, name, effect.parameters[k]);
                given = true;
            }
        }
        if (given && (effect.given_by_liquid || !active.is_neutral())) {
            result.push_back(std::move(active));
        }
    }
    return result;
}

std::vector<std::string> names_of_effects() {
    std::vector<std::string> names;
    for (const Effect& effect : built_in_effects()) {
        names.push_back(effect.name);
    }
    return names;
}

std::string example_of(const std::function<bool(const Effect&)>& wanted) {
    const auto found = std::ranges::find_if(built_in_effects(), wanted);
    if (found == built_in_effects().end()) {
        return "";
    }
    const EffectParameter& parameter = found->parameters.front();
    return fmt::format("--{} {}", key(*found, parameter),
                       printed_word(parameter.neutral + parameter.smallest_of_interest, parameter));
}

}  // namespace pendular::app
