#include "data/effect_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "data/quantities/units.h"

namespace pendular {

EffectParameter on_switch(std::string meaning) {
    return {.name = "on", .unit = "1", .meaning = std::move(meaning)};
}

double Values::operator[](std::string_view name) const {
    const auto found = std::ranges::find(parameters_, name, &EffectParameter::name);
    if (found == parameters_.end()) {
        throw std::logic_error(fmt::format("no parameter '{}' in an effect", name));
    }
    return values_[static_cast<std::size_t>(found - parameters_.begin())];
}

namespace {

/// Whether `name` is the unit `si` times an SI unit, but for rounding. A prefix before "m^2" or
/// "1/s" is not.
bool is_multiple(const std::string& name, double si, const std::string& si_unit) {
    try {
        const Unit unit(name);
        return unit.same_dimension(Unit(si_unit)) && std::abs(unit.to_si(1) / si - 1) < 1e-9;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

}  // namespace

PrintedUnit printed_unit(const EffectParameter& parameter) {
    if (parameter.unit == "rad") return {"deg", std::numbers::pi / 180};
    const bool has_prefix = parameter.unit.starts_with("kg");
    if (parameter.unit == "1" || has_prefix) return {parameter.unit, 1};
    const double largest = std::max(std::abs(parameter.lower), std::abs(parameter.upper));
    PrintedUnit printed{parameter.unit, 1};
    for (const PrintedUnit& prefix : {PrintedUnit{"m", 1e-3}, {"u", 1e-6}}) {
        const std::string name = prefix.name + parameter.unit;
        if (largest < 1000 * prefix.si && is_multiple(name, prefix.si, parameter.unit)) {
            printed = {name, prefix.si};
        }
    }
    return printed;
}

std::string printed_value(double value, const EffectParameter& parameter) {
    const PrintedUnit unit = printed_unit(parameter);
    const std::string number = fmt::format("{:.4g}", value / unit.si);
    return unit.name == "1" ? number : number + " " + unit.name;
}

std::string printed_word(double value, const EffectParameter& parameter) {
    const std::string text = printed_value(value, parameter);
    return text.find(' ') == std::string::npos ? text : '"' + text + '"';
}

std::string printed_bounds(const EffectParameter& parameter) {
    return fmt::format("{:.4g} to {}", parameter.lower / printed_unit(parameter).si,
                       printed_value(parameter.upper, parameter));
}

}  // namespace pendular
