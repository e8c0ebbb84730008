#include "data/study/effect_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "data/quantities/units.h"
#include "data/study/study_table.h"

namespace pendular {
namespace {

using Keys = std::vector<std::string>;

WrittenEffect::Kind kind_of(const std::string& target) {
    const auto is_in = [&](const Keys& targets) {
        return std::ranges::find(targets, target) != targets.end();
    };
    return is_in(instrument_targets()) ? WrittenEffect::Kind::instrument
           : is_in(flow_targets())     ? WrittenEffect::Kind::flow
                                       : WrittenEffect::Kind::condition;
}

Keys effect_keys() {
    Keys keys = {"name",    "parameter", "unit",    "lower",       "upper",
                 "neutral", "matters",   "summary", "measured_by", "measured_to"};
    for (const Keys& targets : {instrument_targets(), flow_targets(), condition_targets()})
        keys.insert(keys.end(), targets.begin(), targets.end());
    return keys;
}

bool is_lower(char c) {
    return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return is_lower(c) || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Whether a name consists of lower-case words joined by hyphens, as the names of built-in effects
/// do.
bool is_effect_name(const std::string& name) {
    return !name.empty() && is_lower(name.front()) && name.back() != '-' &&
           name.find("--") == std::string::npos &&
           std::ranges::all_of(name, [](char c) { return is_lower(c) || is_digit(c) || c == '-'; });
}

/// Whether a word can be the name of a variable in a formula.
bool is_identifier(const std::string& word) {
    return !word.empty() && is_letter(word.front()) &&
           std::ranges::all_of(word, [](char c) { return is_letter(c) || is_digit(c); });
}

std::string required_text(const StudyTable& table, std::string_view key, const char* example) {
    const auto text = table.text(key);
    if (!text)
        throw InputError(table.position(),
                         fmt::format("[[effect]] lacks '{}'; add {} = \"{}\"", key, key, example));
    return *text;
}

/// Unit of an effect's parameter, in any spelling; "1" if the key is missing.
/// @throws InputError if the text is no unit, or if the unit's zero is not that of the SI unit
///         (degrees Celsius)
Unit parameter_unit(const StudyTable& table) {
    try {
        Unit unit(table.text("unit").value_or("1"));
        if (unit.to_si(0) != 0)
            table.refuse("unit",
                         "has another zero than the SI unit; use the SI unit, K for temperatures");
        return unit;
    } catch (const std::invalid_argument& error) {
        table.refuse("unit", error.what());
    }
}

double required_bound(const StudyTable& table, std::string_view key, const Unit& unit) {
    if (const auto value = table.quantity_in(key, unit)) return *value;
    throw InputError(table.position(),
                     fmt::format("[[effect]] lacks '{}'; add the {} bound of the parameter, "
                                 "{} = ...",
                                 key, key == "lower" ? "lowest" : "highest", key));
}

/// Checks that the table of a switch, an effect that is only on or off, states no other bounds than
/// 0 and 1 and no unit.
/// @throws InputError if the table states other bounds or a unit
void check_switch(const StudyTable& table) {
    constexpr std::array<std::pair<const char*, double>, 4> fixed = {
        {{"lower", 0}, {"upper", 1}, {"neutral", 0}, {"matters", 1}}};
    for (const auto& [key, value] : fixed)
        if (table.quantity(key, "1").value_or(value) != value)
            table.refuse(key, fmt::format("of a switch is {}; leave it out", value));
    if (!parameter_unit(table).dimension().empty())
        table.refuse("unit", "a switch has none; leave it out");
}

void read_bounds(const StudyTable& table, WrittenEffect& effect) {
    const Unit unit = parameter_unit(table);
    effect.unit = si_spelling(unit);
    effect.lower = required_bound(table, "lower", unit);
    effect.upper = required_bound(table, "upper", unit);
    if (effect.lower >= effect.upper) table.refuse("lower", "must be less than 'upper'");
    effect.neutral = table.quantity_in("neutral", unit).value_or(0);
    if (effect.neutral < effect.lower || effect.neutral > effect.upper)
        table.refuse("neutral",
                     fmt::format("the neutral value, {:g} where 'neutral' is left out, must lie "
                                 "between 'lower' and 'upper', so that the effect can be absent",
                                 effect.neutral));
    effect.smallest_of_interest =
        table.quantity_in("matters", unit).value_or((effect.upper - effect.lower) / 10);
    if (effect.smallest_of_interest <= 0) table.refuse("matters", "must be positive");
}

/// Formulas that a table [[effect]] has for the given targets, the quantities that formulas set.
std::vector<Formula> formulas_of(const StudyTable& table, const Keys& targets) {
    std::vector<Formula> formulas;
    for (const std::string& target : targets)
        if (const auto text = table.text(target))
            formulas.push_back({target, *text, table.at(target)});
    return formulas;
}

/// Text that says what a target of formulas is, for messages.
const char* subject_of(const std::string& target) {
    switch (kind_of(target)) {
        case WrittenEffect::Kind::instrument:
            return "a quantity of the instrument";
        case WrittenEffect::Kind::flow:
            return "a quantity of the flow";
        default:
            return "a property of the beads or of their liquid";
    }
}

std::vector<Formula> read_formulas(const StudyTable& table, const WrittenEffect& effect) {
    std::vector<Formula> formulas;
    for (const Keys& targets : {instrument_targets(), flow_targets(), condition_targets()}) {
        const std::vector<Formula> more = formulas_of(table, targets);
        if (!formulas.empty() && !more.empty())
            table.refuse(more.front().target,
                         fmt::format("is {}, but '{}' is {}; write two effects",
                                     subject_of(more.front().target), formulas.front().target,
                                     subject_of(formulas.front().target)));
        if (formulas.empty()) formulas = more;
    }
    if (formulas.empty())
        throw InputError(effect.position,
                         fmt::format("[[effect]] '{}' has no formula; add one for a quantity that "
                                     "the instrument shows, such as torque = \"torque + {}\"",
                                     effect.name, effect.parameter));
    return formulas;
}

/// Reads a text of one line; empty if the key is missing.
std::string line_of_text(const StudyTable& table, std::string_view key) {
    std::string text = table.text(key).value_or("");
    if (text.find_first_of("\r\n") != std::string::npos) table.refuse(key, "must be one line");
    return text;
}

/// Reads what measures the parameter of an effect directly.
void read_direct_method(const StudyTable& table, WrittenEffect& effect) {
    effect.measured_by = line_of_text(table, "measured_by");
    if (!effect.measured_by.empty() && effect.parameter == "on")
        table.refuse("measured_by", "a switch has no size that could be measured; leave it out");
    const auto error = table.quantity_in("measured_to", parameter_unit(table));
    if (!error) return;
    if (!(*error > 0)) table.refuse("measured_to", "must be a standard error above 0");
    if (effect.measured_by.empty())
        table.refuse("measured_to",
                     "is the standard error of a direct measurement; add measured_by "
                     "= \"...\", which says what measures the parameter");
    effect.measured_to = *error;
}

WrittenEffect read_effect(const StudyTable& table) {
    WrittenEffect effect;
    effect.position = table.position();
    effect.name = required_text(table, "name", "my-effect");
    effect.name_position = table.at("name");
    if (!is_effect_name(effect.name))
        table.refuse("name", fmt::format("\"{}\" must be lower-case words joined by hyphens, as "
                                         "\"torque-offset\" is",
                                         effect.name));
    effect.parameter = required_text(table, "parameter", "amplitude");
    effect.parameter_position = table.at("parameter");
    if (!is_identifier(effect.parameter))
        table.refuse("parameter", fmt::format("\"{}\" must be one word of letters, digits and _ "
                                              "that begins with a letter",
                                              effect.parameter));
    if (effect.parameter == "on")
        check_switch(table);
    else
        read_bounds(table, effect);
    effect.summary = line_of_text(table, "summary");
    read_direct_method(table, effect);
    effect.formulas = read_formulas(table, effect);
    return effect;
}

}  // namespace

const std::vector<std::string>& instrument_targets() {
    static const Keys targets = {"torque", "normal_force", "height", "angular_velocity"};
    return targets;
}

const std::vector<std::string>& flow_targets() {
    static const Keys targets = {"stress_ratio", "solid_fraction"};
    return targets;
}

const std::vector<std::string>& condition_targets() {
    static const Keys targets = {"friction_difference", "surface_tension"};
    return targets;
}

WrittenEffect::Kind WrittenEffect::kind() const {
    return kind_of(formulas.at(0).target);
}

std::vector<WrittenEffect> read_written_effects(const StudyTable& root) {
    std::vector<WrittenEffect> effects;
    for (const StudyTable& table : root.tables("effect", effect_keys())) {
        const WrittenEffect effect = read_effect(table);
        const auto earlier = std::ranges::find(effects, effect.name, &WrittenEffect::name);
        if (earlier != effects.end())
            table.refuse("name",
                         fmt::format("\"{}\" is already defined in line {}; choose another name",
                                     effect.name, earlier->position.line));
        effects.push_back(effect);
    }
    return effects;
}

}  // namespace pendular
