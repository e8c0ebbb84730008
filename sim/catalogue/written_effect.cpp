#include "sim/catalogue/written_effect.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "data/quantities/number.h"
#include "sim/catalogue/formula.h"

namespace pendular {
namespace {

/// Stress ratio and solid fraction of grains at a condition, with the condition.
struct GrainState {
    FlowPoint shown;
    Condition condition;
};

/// Truly imposed condition of grains, with properties of the grains and of their liquid.
struct ImposedState {
    EffectiveCondition condition;
    double surface_tension = 0;  ///< of the liquid [N/m]; 0: dry grains
};

/// Variable that a formula can read from a state.
template <typename State>
struct Variable {
    const char* name;
    const char* unit;  ///< SI unit
    double (*value)(const State&);
};

/// Quantity of a state that a formula can set.
template <typename State>
struct Target {
    const char* name;
    const char* unit;  ///< SI unit
    double& (*value)(State&);
};

/// Variables and targets of formulas, and typical states on which formulas are checked, for effects
/// on the instrument (CellState), on the flow (GrainState) and on grains and liquid (ImposedState).
template <typename State>
struct Field;

template <>
struct Field<CellState> {
    static constexpr Variable<CellState> variables[] = {
        {"torque", "N m", [](const CellState& s) { return s.torque; }},
        {"normal_force", "N", [](const CellState& s) { return s.normal_force; }},
        {"height", "m", [](const CellState& s) { return s.height; }},
        {"angular_velocity", "rad/s", [](const CellState& s) { return s.angular_velocity; }},
        {"liquid_content", "1", [](const CellState& s) { return s.liquid_content; }},
        {"bead_volume", "m^3", [](const CellState& s) { return s.bead_volume; }},
        {"time", "s", [](const CellState& s) { return s.time; }},
        {"inner_radius", "m", [](const CellState& s) { return s.inner_radius; }},
        {"outer_radius", "m", [](const CellState& s) { return s.outer_radius; }},
        {"density", "kg/m^3", [](const CellState& s) { return s.density; }},
        {"diameter", "m", [](const CellState& s) { return s.diameter; }},
        {"normal_stress", "Pa", [](const CellState& s) { return s.normal_force / s.area(); }}};
    static constexpr Target<CellState> targets[] = {
        {"torque", "N m", [](CellState& s) -> double& { return s.torque; }},
        {"normal_force", "N", [](CellState& s) -> double& { return s.normal_force; }},
        {"height", "m", [](CellState& s) -> double& { return s.height; }},
        {"angular_velocity", "rad/s", [](CellState& s) -> double& { return s.angular_velocity; }}};

    /// Typical state: 60 g of beads in a 21/45 mm cell at a normal stress of 3 kPa if `large`, else
    /// 0.3 kPa.
    static CellState typical(bool large, double liquid_content, double time) {
        return {.torque = large ? 0.16 : 0.012,
                .normal_force = large ? 15.0 : 1.5,
                .height = large ? 0.0187 : 0.0191,
                .angular_velocity = large ? 1.7 : 0.05,
                .liquid_content = liquid_content,
                .bead_volume = 57e-6,
                .time = time,
                .inner_radius = 0.021,
                .outer_radius = 0.045,
                .density = 1050,
                .diameter = 500e-6};
    }
    static double liquid_content(const CellState& state) { return state.liquid_content; }
};

template <>
struct Field<GrainState> {
    static constexpr Variable<GrainState> variables[] = {
        {"stress_ratio", "1", [](const GrainState& s) { return s.shown.stress_ratio; }},
        {"solid_fraction", "1", [](const GrainState& s) { return s.shown.solid_fraction; }},
        {"normal_stress", "Pa", [](const GrainState& s) { return s.condition.normal_stress; }},
        {"inertial_number", "1", [](const GrainState& s) { return s.condition.inertial_number; }},
        {"liquid_content", "1", [](const GrainState& s) { return s.condition.liquid_content; }},
        {"height", "m",
         [](const GrainState& s) {
             return s.condition.height.value_or(std::numeric_limits<double>::quiet_NaN());
         }},
        {"time", "s", [](const GrainState& s) { return s.condition.time; }}};
    static constexpr Target<GrainState> targets[] = {
        {"stress_ratio", "1", [](GrainState& s) -> double& { return s.shown.stress_ratio; }},
        {"solid_fraction", "1", [](GrainState& s) -> double& { return s.shown.solid_fraction; }}};

    static GrainState typical(bool large, double liquid_content, double time) {
        GrainState state;
        state.shown = {large ? 0.35 : 0.27, large ? 0.57 : 0.59};
        state.condition.normal_stress = large ? 3000 : 300;
        state.condition.inertial_number = large ? 0.1 : 0.001;
        state.condition.liquid_content = liquid_content;
        state.condition.height = 0.019;
        state.condition.time = time;
        return state;
    }
    static double liquid_content(const GrainState& state) { return state.condition.liquid_content; }
};

template <>
struct Field<ImposedState> {
    static constexpr Variable<ImposedState> variables[] = {
        {"friction_difference", "1",
         [](const ImposedState& s) { return s.condition.friction_difference; }},
        {"surface_tension", "N/m", [](const ImposedState& s) { return s.surface_tension; }},
        {"normal_stress", "Pa", [](const ImposedState& s) { return s.condition.normal_stress; }},
        {"inertial_number", "1", [](const ImposedState& s) { return s.condition.inertial_number; }},
        {"liquid_content", "1", [](const ImposedState& s) { return s.condition.liquid_content; }},
        {"height", "m",
         [](const ImposedState& s) {
             return s.condition.height.value_or(std::numeric_limits<double>::quiet_NaN());
         }},
        {"time", "s", [](const ImposedState& s) { return s.condition.time; }}};
    static constexpr Target<ImposedState> targets[] = {
        {"friction_difference", "1",
         [](ImposedState& s) -> double& { return s.condition.friction_difference; }},
        {"surface_tension", "N/m", [](ImposedState& s) -> double& { return s.surface_tension; }}};

    static ImposedState typical(bool large, double liquid_content, double time) {
        return {Field<GrainState>::typical(large, liquid_content, time).condition,
                liquid_content > 0 ? 0.05 : 0};
    }
    static double liquid_content(const ImposedState& state) {
        return state.condition.liquid_content;
    }
};

template <typename State>
std::vector<State> typical_states() {
    std::vector<State> states;
    for (const bool large : {false, true}) {
        for (const double liquid_content : {0.0, 1e-4, 0.03}) {
            for (const double time : {0.0, 3600.0}) {
                states.push_back(Field<State>::typical(large, liquid_content, time));
            }
        }
    }
    return states;
}

/// Returns the names that formulas can contain: variables of the state, then the parameter.
template <typename State>
std::vector<std::string> known_names(const std::string& parameter) {
    std::vector<std::string> names;
    for (const auto& variable : Field<State>::variables) {
        names.emplace_back(variable.name);
    }
    names.push_back(parameter);
    return names;
}

/// One compiled formula with the quantity that it sets.
template <typename State>
class ShownValue {
  public:
    ShownValue(const WrittenEffect& effect, const Formula& formula)
        : effect_(effect.name),
          formula_(formula),
          names_(known_names<State>(effect.parameter)),
          compiled_(compile()) {
        for (const auto& target : Field<State>::targets) {
            if (formula.target == target.name) {
                target_ = target.value;
            }
        }
        if (!compiled_.uses(effect.parameter)) {
            refuse(
                fmt::format("does not contain the parameter '{}', so that nothing can be fitted or "
                            "switched off",
                            effect.parameter));
        }
    }

    double of(const State& state, double parameter) const {
        return compiled_(values(state, parameter));
    }
    /// Value of the target before the formula is applied.
    double before(const State& state) const {
        State copy = state;
        return target_(copy);
    }
    void set(State& state, double value) const { target_(state) = value; }

    /// Returns the value of the formula.
    /// @throws InputError where the value is not finite, or so large that its square overflows soon
    /// @throws std::domain_error where the state is to blame: no true state of the cell gives it
    double checked(const State& state, double parameter) const {
        const double value = of(state, parameter);
        if (!(std::abs(value) <= largest_magnitude)) {
            if (std::is_same_v<State, CellState> && !knows(state, parameter))
                throw std::domain_error(
                    "no true state of the cell gives what the instrument shows");
            refuse(
                fmt::format("gives {} at {}; guard it with CONDITION ? A : B, or correct the "
                            "bounds",
                            value, mentioned(state, parameter)));
        }
        return value;
    }

    /// Whether the formula's variables have finite values.
    bool knows(const State& state, double parameter) const {
        const auto all = values(state, parameter);
        for (std::size_t k = 0; k < names_.size(); ++k)
            if (compiled_.uses(names_[k]) && !std::isfinite(all[k])) return false;
        return true;
    }

    /// Returns the values of the formula's variables as text, as in "torque = 0.1, drag = 3".
    std::string mentioned(const State& state, double parameter) const {
        const auto all = values(state, parameter);
        std::vector<std::string> parts;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (compiled_.uses(names_[k])) {
                parts.push_back(fmt::format("{} = {:g}", names_[k], all[k]));
            }
        }
        return fmt::format("{}", fmt::join(parts, ", "));
    }

    [[noreturn]] void refuse(const std::string& what) const {
        throw InputError(formula_.position,
                         fmt::format("'{}' of effect '{}': {}", formula_.target, effect_, what));
    }

    /// @throws InputError where the parameter's unit gives the formula another dimension than its
    ///         quantity has
    void check_unit(const WrittenEffect& effect) const {
        FormulaUnits units;
        for (const auto& variable : Field<State>::variables) {
            units.variables.push_back(variable.unit);
        }
        units.variables.push_back(effect.unit);
        for (const auto& target : Field<State>::targets) {
            if (formula_.target == target.name) units.target = target.unit;
        }
        std::vector<std::vector<double>> states;
        for (const State& state : typical_states<State>()) {
            states.push_back(
                values(state, effect.upper != effect.neutral ? effect.upper : effect.lower));
        }
        const auto better = better_unit(compiled_, formula_.text, units, states);
        if (!better) return;
        refuse(better->empty()
                   ? fmt::format("does not have the unit of a {}, {}, whatever the unit of '{}'",
                                 formula_.target, units.target, effect.parameter)
                   : fmt::format("has the unit of a {}, {}, only if '{}' is in {}; its unit is {}",
                                 formula_.target, units.target, effect.parameter, *better,
                                 effect.unit));
    }

    const Formula& formula() const { return formula_; }
    const CompiledFormula& compiled() const { return compiled_; }

  private:
    CompiledFormula compile() const {
        try {
            return {formula_.text, names_};
        } catch (const FormulaError& error) {
            refuse(error.what());
        }
    }
    std::vector<double> values(const State& state, double parameter) const {
        std::vector<double> result;
        for (const auto& variable : Field<State>::variables) {
            result.push_back(variable.value(state));
        }
        result.push_back(parameter);
        return result;
    }

    std::string effect_;
    Formula formula_;
    std::vector<std::string> names_;
    CompiledFormula compiled_;
    double& (*target_)(State&) = nullptr;
};

/// All formulas of an effect. Each formula reads the state as it is before any formula is applied.
template <typename State>
class ShownValues {
  public:
    explicit ShownValues(const WrittenEffect& effect) {
        for (const Formula& formula : effect.formulas) {
            formulas_.emplace_back(effect, formula);
        }
        for (const auto& formula : formulas_) {
            check_neutral(formula, effect);
            if (effect.unit != "1") formula.check_unit(effect);  // else the unit may be left out
            for (const double bound : {effect.lower, effect.upper}) {
                for (const State& state : typical_states<State>()) {
                    formula.checked(state, bound);
                }
            }
        }
        touches_ = find_touches(effect);
    }

    State operator()(const State& state, double parameter) const {
        State shown = state;
        for (const auto& formula : formulas_) {
            formula.set(shown, formula.checked(state, parameter));
        }
        return shown;
    }

    Touches touches() const { return touches_; }

    /// Returns the variables in the formulas other than the parameter and each formula's own
    /// target; the normal force counts as `normal_stress`.
    std::vector<std::string> covariates(const std::string& parameter) const {
        std::vector<std::string> names;
        for (const auto& formula : formulas_) {
            for (const std::string& used : formula.compiled().used()) {
                const std::string name = used == "normal_force" ? "normal_stress" : used;
                if (used != parameter && used != formula.formula().target &&
                    std::ranges::find(names, name) == names.end()) {
                    names.push_back(name);
                }
            }
        }
        return names;
    }

  private:
    static void check_neutral(const ShownValue<State>& formula, const WrittenEffect& effect) {
        constexpr double rounding = 1e-12;
        const std::string& target = formula.formula().target;
        for (const State& state : typical_states<State>()) {
            const double before = formula.before(state), after = formula.of(state, effect.neutral);
            if (!(std::abs(after - before) <= rounding * std::abs(before))) {
                formula.refuse(fmt::format(
                    "at the neutral value {} = {:g} the formula must give back '{}' itself; at {} "
                    "it gives {:g}",
                    effect.parameter, effect.neutral, target,
                    formula.mentioned(state, effect.neutral), after));
            }
        }
    }

    /// Whether the formulas change a state at the lower or the upper bound of the parameter.
    bool changes(const State& state, const WrittenEffect& effect) const {
        return std::ranges::any_of(formulas_, [&](const auto& formula) {
            const double before = formula.before(state);
            return formula.of(state, effect.lower) != before ||
                   formula.of(state, effect.upper) != before;
        });
    }

    Touches find_touches(const WrittenEffect& effect) const {
        bool dry = false, wet = false;
        for (const State& state : typical_states<State>()) {
            (Field<State>::liquid_content(state) > 0 ? wet : dry) |= changes(state, effect);
        }
        return dry == wet ? Touches::all : dry ? Touches::dry : Touches::wet;
    }

    std::vector<ShownValue<State>> formulas_;
    Touches touches_ = Touches::all;
};

/// Checks the name of the parameter, which would hide a variable or function of the same name.
/// @throws InputError where a variable or function has this name
void check_parameter(const WrittenEffect& written) {
    std::vector<std::string> taken = CompiledFormula::reserved_words();
    for (const auto& names :
         {known_names<CellState>(""), known_names<GrainState>(""), known_names<ImposedState>("")}) {
        taken.insert(taken.end(), names.begin(), names.end());
    }
    if (std::ranges::find(taken, written.parameter) != taken.end()) {
        throw InputError(written.parameter_position,
                         fmt::format("'parameter': '{0}' is already a variable or function of "
                                     "formulas; choose another name, such as '{0}_change'",
                                     written.parameter));
    }
}

EffectParameter parameter_of(const WrittenEffect& written) {
    if (written.parameter == "on") {
        return on_switch("whether the formulas hold");
    }
    return {.name = written.parameter,
            .unit = written.unit,
            .lower = written.lower,
            .upper = written.upper,
            .neutral = written.neutral,
            .smallest_of_interest = written.smallest_of_interest,
            .meaning = "as in the formulas of study.toml"};
}

std::string equation_of(const WrittenEffect& written) {
    std::vector<std::string> lines;
    for (const Formula& formula : written.formulas) {
        const char* format =
            written.kind() == WrittenEffect::Kind::condition ? "{} becomes {}" : "{}_shown = {}";
        lines.push_back(fmt::format(fmt::runtime(format), formula.target, formula.text));
    }
    return fmt::format("{}", fmt::join(lines, "\n"));
}

Change change_of(std::shared_ptr<const ShownValues<CellState>> shown, std::string parameter) {
    return ChangeInstrument{.show = [shown = std::move(shown), parameter = std::move(parameter)](
                                        const CellState& state,
                                        const Values& v) { return (*shown)(state, v[parameter]); },
                            .where = ChangeInstrument::Where::transducers};
}

Change change_of(std::shared_ptr<const ShownValues<GrainState>> shown, std::string parameter) {
    return ChangeFlow{[shown = std::move(shown), parameter = std::move(parameter)](
                          FlowPoint point, const Condition& condition, const Values& v) {
        return (*shown)({point, condition}, v[parameter]).shown;
    }};
}

Change change_of(std::shared_ptr<const ShownValues<ImposedState>> changed, std::string parameter) {
    return ChangeCondition{[changed = std::move(changed), parameter = std::move(parameter)](
                               const EffectiveCondition& condition, const Values& v) {
        ImposedState state{condition, condition.liquid ? condition.liquid->surface_tension : 0};
        state = (*changed)(state, v[parameter]);
        if (state.condition.liquid) state.condition.liquid->surface_tension = state.surface_tension;
        return state.condition;
    }};
}

template <typename State>
Effect effect_of(const WrittenEffect& written) {
    const auto shown = std::make_shared<const ShownValues<State>>(written);
    const std::string file = std::filesystem::path(written.position.file).filename().string();
    return {.name = written.name,
            .summary = written.summary.empty() ? "written in " + file : written.summary,
            .equation = equation_of(written),
            .parameters = {parameter_of(written)},
            .change = change_of(shown, written.parameter),
            .touches = shown->touches(),
            .acts_through = shown->covariates(written.parameter),
            .directly = written.measured_by,
            .reachable_error = written.measured_to,
            .references = {fmt::format("{}:{}", file, written.position.line)}};
}

}  // namespace

Effect effect_from(const WrittenEffect& written) {
    check_parameter(written);
    switch (written.kind()) {
        case WrittenEffect::Kind::instrument:
            return effect_of<CellState>(written);
        case WrittenEffect::Kind::flow:
            return effect_of<GrainState>(written);
        default:
            return effect_of<ImposedState>(written);
    }
}

}  // namespace pendular
