#include "sim/catalogue/shared_uncertainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "data/input_error.h"
#include "data/quantities/units.h"
#include "sim/catalogue/unknown_walls.h"

namespace pendular {
namespace {

using Show = std::function<CellState(CellState, double)>;

/// Effect of an error of a quantity that study.toml states, with the error as its parameter.
Effect error_of(std::string key, Change change, Touches touches = Touches::all) {
    return {.name = std::move(key),
            .summary = {},
            .equation = {},
            .parameters = {{.name = "error", .lower = -1, .upper = 1}},
            .change = std::move(change),
            .touches = touches};
}
Effect error_of_state(std::string key, Show show) {
    return error_of(std::move(key), ChangeInstrument{[show](CellState state, const Values& v) {
                        return show(state, v["error"]);
                    }});
}
Effect error_of_liquid(std::string key, std::function<void(Liquid&, double)> change) {
    return error_of(std::move(key),
                    ChangeCondition{[change](EffectiveCondition condition, const Values& v) {
                        change(condition.liquid.value(), v["error"]);
                        return condition;
                    }},
                    Touches::wet);
}

/// Effect of an error that multiplies one quantity of the shown state by (1 + error)^power.
Effect error_of_factor(std::string key, double CellState::*quantity, double power) {
    return error_of_state(std::move(key), [=](CellState state, double e) {
        state.*quantity *= std::pow(1 + e, power);
        return state;
    });
}

/// State that the instrument shows if the true radii differ from the stated ones. In `state`,
/// torque, force, height and angular velocity are those that would cause the true stresses, solid
/// fraction and shear rate in a cell of the stated radii.
CellState shown_in_cell(CellState state, double inner, double outer) {
    const double ri = state.inner_radius, re = state.outer_radius;
    const double area = (outer * outer - inner * inner) / (re * re - ri * ri);
    state.torque *= (std::pow(outer, 3) - std::pow(inner, 3)) / (std::pow(re, 3) - std::pow(ri, 3));
    state.normal_force *= area;
    state.height /= area;
    state.angular_velocity *= (ri + re) / (inner + outer) / area;
    return state;
}

/// Name of the effect of the density on the volume of beads that a balance weighed.
const std::string weighed_density = "density of weighed beads";

/// Effects of errors of the quantities that study.toml states, by its keys. A positive error of a
/// key of [cell], [grains] or [liquid] or of the liquid content means that the true value is larger
/// than the stated one, a positive error of the speed that the shown value is larger than the true
/// one.
const std::vector<Effect>& errors_of_keys() {
    static const std::vector<Effect> effects = {
        error_of_state("inner_radius",
                       [](const CellState& s, double e) {
                           return shown_in_cell(s, s.inner_radius * (1 + e), s.outer_radius);
                       }),
        error_of_state("outer_radius",
                       [](const CellState& s, double e) {
                           return shown_in_cell(s, s.inner_radius, s.outer_radius * (1 + e));
                       }),
        error_of_factor("bead_mass", &CellState::bead_volume, -1),
        // The inertial number at the true density, and the volume of weighed beads.
        error_of_factor("density", &CellState::angular_velocity, -0.5),
        error_of_factor(weighed_density, &CellState::bead_volume, 1),
        error_of_factor("diameter", &CellState::angular_velocity, -1),
        // The reduced pressure is proportional to the diameter over the surface tension.
        error_of_liquid("diameter", [](Liquid& l, double e) { l.surface_tension /= 1 + e; }),
        error_of_factor("angular_velocity", &CellState::angular_velocity, 1),
        error_of_factor("liquid_content", &CellState::liquid_content, -1),
        error_of_liquid("surface_tension", [](Liquid& l, double e) { l.surface_tension *= 1 + e; }),
        error_of_liquid("contact_angle", [](Liquid& l, double e) {
            l.contact_angle = std::clamp(l.contact_angle + e, 0.0, 89 * std::numbers::pi / 180);
        })};
    return effects;
}

/// Meaning of a name in [instrument].
struct Meaning {
    const char* name;
    /// Typical standard uncertainty, in `unit`, of a rheometer with an annular cell or of a table;
    /// 0: none is assumed.
    double typical;
    const char* unit;  ///< of `typical`; "1": relative
    /// Value in study.toml that an absolute uncertainty is divided by; 0: missing there.
    double (*stated)(const Study&) = nullptr;
    const char* stated_unit = "1";

    /// Whether `typical` is a length, to be divided by the stated one.
    constexpr bool typical_is_absolute() const { return stated && std::string_view(unit) == "m"; }
};

enum class Needs { cell, table, liquid, beads };

double none(const Study&) {
    return 0;
}

// Typical values are chosen: those of gains and zeros are about what data sheets of rotational
// rheometers give after a calibration, those of lengths are tolerances of turned parts and of
// setting a gap on grains, and those of beads and liquids are about what suppliers state.
struct Known {
    Needs needs;
    Meaning meaning;
};
constexpr std::array known = {
    Known{Needs::cell, {"torque-gain", 0.02, "1"}},
    Known{Needs::cell, {"torque-offset", 0.2e-3, "N m"}},
    Known{Needs::cell, {"normal-force-gain", 0.01, "1"}},
    Known{Needs::cell, {"normal-force-offset", 0.05, "N"}},
    Known{Needs::cell, {"height-offset", 30e-6, "m"}},
    Known{Needs::cell,
          {"inner_radius", 0.05e-3, "m", [](const Study& s) { return s.cell->inner_radius; }, "m"}},
    Known{Needs::cell,
          {"outer_radius", 0.05e-3, "m", [](const Study& s) { return s.cell->outer_radius; }, "m"}},
    Known{Needs::cell,
          {"bead_mass", 0.002, "1",
           [](const Study& s) { return s.cell->bead_volume * s.grains.density; }, "kg"}},
    Known{Needs::cell,
          {"density", 0.01, "1", [](const Study& s) { return s.grains.density; }, "kg/m^3"}},
    Known{Needs::cell, {"angular_velocity", 0.001, "1", none}},
    Known{Needs::table, {"shear_stress", 0.02, "1", none}},
    Known{Needs::table, {"normal_stress", 0.01, "1", none}},
    Known{Needs::table, {"solid_fraction", 0.005, "1", none}},
    Known{Needs::beads,
          {"diameter", 0.02, "1", [](const Study& s) { return s.grains.diameter; }, "m"}},
    Known{Needs::liquid, {"liquid_content", 0.05, "1", none}},
    Known{Needs::liquid,
          {"surface_tension", 0.02, "1", [](const Study& s) { return s.liquid->surface_tension; },
           "N/m"}},
    Known{Needs::liquid, {"contact_angle", 5 * std::numbers::pi / 180, "rad", none, "rad"}}};

/// Why a quantity does not matter for a study; empty if it does.
std::string obstacle_to(Needs needs, const Study& study) {
    if (needs == Needs::cell && !study.cell)
        return "is a quantity of a cell, but the study has no [cell]; for tables of readings, "
               "state shear_stress, normal_stress and solid_fraction";
    if (needs == Needs::table && study.cell)
        return "is for tables of readings without a cell; state what it follows from: torque-gain, "
               "normal-force-gain, bead_mass and the radii";
    if (needs == Needs::beads && !study.cell && !study.liquid)
        return "changes nothing in a table of dry readings without a cell";
    if (needs == Needs::liquid && !study.liquid) return "is of the liquid, but the study has none";
    return "";
}

/// Name of an effect that a key would have, such as "contact-angle" for "contact_angle".
std::string as_effect(std::string name) {
    std::ranges::replace(name, '_', '-');
    return name;
}

/// Whether an effect is the gain of a quantity of tables, such as shear-stress-gain of
/// "shear_stress".
bool is_gain_of(const Effect& effect, const std::string& quantity) {
    return effect.of_table() && effect.name == as_effect(quantity) + "-gain";
}

/// Built-in effects of the instrument with one fitted parameter, or the effects of a key's error.
std::vector<const Effect*> effects_of(const std::string& name, const Study& study) {
    std::vector<const Effect*> effects;
    for (const Effect& effect : errors_of_keys()) {
        // A table without a cell states inertial numbers, which an error of the diameter leaves.
        if (effect.name == "diameter" && effect.of_instrument() && !study.cell) continue;
        if (effect.name == name ||
            (name == "density" && effect.name == weighed_density && study.beads_weighed))
            effects.push_back(&effect);
    }
    for (const Effect& effect : built_in_effects())
        if ((effect.name == name || is_gain_of(effect, name)) && effect.of_instrument() &&
            !effect.is_switch())
            effects.push_back(&effect);
    return effects;
}

/// Names that a study may state.
std::vector<std::string> names_for(const Study& study) {
    std::vector<std::string> names;
    for (const Known& each : known)
        if (obstacle_to(each.needs, study).empty()) names.emplace_back(each.meaning.name);
    for (const Effect& effect : built_in_effects())
        if (effect.of_instrument() && effect.of_table() != study.cell.has_value() &&
            !effect.is_switch() && std::ranges::find(names, effect.name) == names.end())
            names.push_back(effect.name);
    return names;
}

const Known* known_named(const std::string& name) {
    const auto found =
        std::ranges::find_if(known, [&](const Known& each) { return each.meaning.name == name; });
    return found == known.end() ? nullptr : &*found;
}

/// Unit in which an uncertainty is stated: that of the effect's parameter or of the key.
std::string unit_of(const std::string& name, const Study& study) {
    const Known* const each = known_named(name);
    if (each && each->meaning.stated) return each->meaning.stated_unit;
    return effects_of(name, study).front()->parameters.front().unit;
}

double absolute_in_si(const StatedUncertainty& stated, const std::string& unit) {
    try {
        return quantity_in_si(stated.value, Unit(unit));
    } catch (const std::invalid_argument& error) {
        throw InputError(stated.position, fmt::format("'{}': {}", stated.name, error.what()));
    }
}

/// Reads a stated value: absolute in the unit of the quantity, or relative, as in "1 %".
SharedUncertainty uncertainty_of(const StatedUncertainty& stated, const Study& study) {
    const auto refuse = [&](const std::string& why) -> void {
        throw InputError(stated.position, fmt::format("'{}': {}", stated.name, why));
    };
    SharedUncertainty result{.name = stated.name, .effects = effects_of(stated.name, study)};
    const Known* const each = known_named(stated.name);
    if (each) {
        if (const std::string why = obstacle_to(each->needs, study); !why.empty()) refuse(why);
    }
    if (result.effects.empty()) {
        refuse(fmt::format("is no quantity whose uncertainty [instrument] can state; {}",
                           did_you_mean(stated.name, names_for(study))));
    }
    const bool of_table = result.effects.front()->of_table();
    if (!each && of_table) {
        if (const std::string why = obstacle_to(Needs::table, study); !why.empty()) refuse(why);
    }
    if (!each && !study.cell && !of_table)
        refuse("acts on the instrument, but the study has no [cell]; add it, or leave this out");
    const std::string unit = unit_of(stated.name, study);
    const double size = each && each->meaning.stated ? each->meaning.stated(study) : 0;
    const bool may_be_relative = unit == "1" || (each && each->meaning.stated && unit != "rad");
    try {
        result.standard = quantity_in_si(stated.value, Unit(may_be_relative ? "1" : unit));
        if (!may_be_relative) result.unit = unit;
    } catch (const std::invalid_argument& error) {
        if (unit == "1") refuse("is a share of the value; write it as in \"1 %\"");
        if (!may_be_relative || size == 0) refuse(error.what());
        result.standard = absolute_in_si(stated, unit) / size;
    }
    if (!(result.standard > 0)) refuse("must be positive");
    // Chosen: what is known less well than to a factor of two has another unit, or is not known.
    if (result.unit == "1" && result.standard > 0.5)
        refuse("must be at most 50 % of the value; check its unit");
    const EffectParameter& p = result.effects.front()->parameters.front();
    if (result.unit != "1" && result.standard > (p.upper - p.lower) / 2)
        refuse("is larger than the effect may be; check its unit");
    return result;
}

/// The effects of a study's instrument without a typical size, unless they are stated.
/// @param sized the uncertainties with a size, whose effects are left out
std::vector<SharedUncertainty> without_size(const Study& study,
                                            const std::vector<SharedUncertainty>& sized) {
    std::vector<SharedUncertainty> all;
    for (const std::string& name : names_for(study)) {
        const std::vector<const Effect*> effects = effects_of(name, study);
        const bool has_size =
            known_named(name) || std::ranges::any_of(sized, [&](const SharedUncertainty& each) {
                return std::ranges::find(each.effects, effects.front()) != each.effects.end() ||
                       each.is_fitted_by(*effects.front());
            });
        if (has_size) continue;
        const std::vector<EffectParameter>& parameters = effects.front()->parameters;
        if (parameters.size() != 1 || !(parameters.front().smallest_of_interest > 0)) continue;
        // Uneven shear is no error of an instrument that every cell may have.
        if (effects.front()->of_uneven_shear) continue;
        all.push_back({.name = name,
                       .standard = parameters.front().smallest_of_interest,
                       .unit = parameters.front().unit,
                       .assumed = true,
                       .counts = false,
                       .unbudgeted = true,
                       .effects = effects});
    }
    return all;
}

SharedUncertainty typical_of(const Meaning& meaning, const Study& study) {
    SharedUncertainty result{.name = meaning.name,
                             .standard = meaning.typical,
                             .unit = meaning.unit,
                             .assumed = true,
                             .effects = effects_of(meaning.name, study)};
    if (meaning.typical_is_absolute()) {
        result.standard /= meaning.stated(study);
        result.unit = "1";
    }
    return result;
}

}  // namespace

bool SharedUncertainty::is_fitted_by(const Effect& effect) const {
    return effect.name == as_effect(name) || is_gain_of(effect, name) ||
           (name == "surface_tension" && effect.given_by_liquid == &Liquid::surface_tension) ||
           (name == unknown_wall_friction && is_of_wall_friction(effect.name));
}

std::vector<ActiveEffect> SharedUncertainty::error(bool below) const {
    std::vector<ActiveEffect> active;
    if (below && one_sided) return active;
    for (const Effect* effect : effects) {
        ActiveEffect each{effect, effect->neutral()};
        for (std::size_t k = 0; k < effect->parameters.size(); ++k)
            if (effect->parameters[k].is_fitted()) each.values[k] += below ? -standard : standard;
        active.push_back(std::move(each));
    }
    return active;
}

std::vector<SharedUncertainty> shared_uncertainties(const Study& study) {
    using Class = InstrumentTable::Class;
    const auto& [kind, class_position, stated] = study.instrument;
    if (kind == Class::rheometer && !study.cell)
        throw InputError(
            class_position,
            "'class': a rheometer needs [cell]; for tables of readings without a cell, "
            "write class = \"table\"");
    if (kind == Class::table && study.cell)
        throw InputError(class_position,
                         "'class': the study has a [cell]; write class = \"rheometer\"");
    std::vector<SharedUncertainty> all;
    for (const StatedUncertainty& each : stated)
        all.push_back(uncertainty_of(each, study));
    for (const Known& each : known) {
        const bool is_stated =
            std::ranges::find(stated, each.meaning.name, &StatedUncertainty::name) != stated.end();
        if (is_stated || !obstacle_to(each.needs, study).empty()) continue;
        if (each.meaning.typical_is_absolute() && each.meaning.stated(study) == 0) continue;
        all.push_back(typical_of(each.meaning, study));
        all.back().counts = kind != Class::none;
    }
    for (const UnknownOfWalls& each : unknown_of_walls(study))
        all.push_back({.name = each.name,
                       .standard = each.root_mean_square,
                       .assumed = true,
                       .counts = false,
                       .one_sided = true,
                       .effects = {each.effect}});
    std::ranges::move(without_size(study, all), std::back_inserter(all));
    return all;
}

}  // namespace pendular
