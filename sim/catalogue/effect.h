#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"
#include "sim/catalogue/cell_state.h"
#include "sim/catalogue/effective_condition.h"
#include "sim/closures/terms.h"
#include "sim/dem/change_pairs.h"

namespace pendular {

/// An instrument effect: one map from the true state of the cell to the shown one. The program
/// inverts it where it must. Effects on the beads in the cell act before those on the transducers.
struct ChangeInstrument {
    std::function<CellState(CellState, const Values&)> show;
    enum class Where { grains, transducers } where = Where::grains;
};

/// An effect that replaces the study's grains or liquid by others: a changed condition rather than
/// new physics. The liquid of a wet condition is filled in.
struct ChangeCondition {
    std::function<EffectiveCondition(EffectiveCondition, const Values&)> change;
};

/// An effect that adds a term to the closures of a base.
struct ChangeClosure {
    std::string base;                       ///< that has the closure, as in "rumpf"
    bool closures::Terms::*term = nullptr;  ///< that is on with the effect
};

/// Stress ratio mu* and solid fraction Phi_S of a state [1].
struct FlowPoint {
    double stress_ratio = 0, solid_fraction = 0;
};

/// An effect that a user states as a formula for what the beads show at a condition, in place of a
/// cause.
struct ChangeFlow {
    std::function<FlowPoint(FlowPoint, const Condition&, const Values&)> change;
};

/// dem::ChangePairs and dem::ChangeSample act on grains and are simulated.
using Change = std::variant<ChangeInstrument, ChangeCondition, dem::ChangePairs, dem::ChangeSample,
                            ChangeClosure, ChangeFlow>;

/// Readings that an effect touches.
enum class Touches { all, dry, wet };

/// A physical effect that may be missing from a model, with all that the program knows of it. Each
/// has one file in sim/effects, after which it is named; CMake collects them.
struct Effect {
    std::string name = {};  ///< from the file's name, as in "torque-offset"
    std::string summary;    ///< one line
    std::string equation;   ///< and where it holds, for the manual; lines of text
    std::vector<EffectParameter> parameters;
    Change change;
    Touches touches = Touches::all;
    /// Whether an effect on grains changes capillary forces, so that its change of the flow is
    /// proportional to 1/P*. An effect with its own forces between wet grains, such as viscosity,
    /// does not.
    bool fades_with_capillarity = false;
    /// The property of a liquid that is the effect's parameter: the effect is on, at that value,
    /// wherever there is a liquid, without being listed. None: off unless listed.
    double Liquid::*given_by_liquid = nullptr;
    std::vector<std::string> acts_through;  ///< covariates its signature grows with
    std::string directly = {};  ///< what measures its parameter by itself; empty where nothing does
    std::vector<std::string> references;

    bool of_instrument() const { return std::holds_alternative<ChangeInstrument>(change); }
    /// Whether it changes what a run simulates.
    bool of_grains() const;
    /// Whether it replaces the study's grains or liquid by others.
    bool of_condition() const { return std::holds_alternative<ChangeCondition>(change); }
    bool of_closure() const { return std::holds_alternative<ChangeClosure>(change); }
    /// The model that it changes: the base that has its closure, or none in particular.
    std::string base() const { return of_closure() ? std::get<ChangeClosure>(change).base : ""; }
    /// Value [its unit] of the first parameter where the effect is not listed: what the liquid
    /// gives, or neutral.
    double unlisted_value(const std::optional<Liquid>& liquid) const;
    /// Whether all its parameters are switches, so that there is nothing to fit.
    bool is_switch() const;
    std::vector<double> neutral() const;
    /// Place of a parameter among the parameters.
    /// @throws std::invalid_argument naming the nearest one
    std::size_t parameter(std::string_view parameter_name) const;
};

/// An effect with the values of its parameters.
struct ActiveEffect {
    const Effect* effect = nullptr;
    std::vector<double> values;  ///< SI, in the order of its parameters

    /// Whether it changes nothing: all its parameters are neutral.
    bool is_neutral() const { return values == effect->neutral(); }
    Values by_name() const { return {effect->parameters, values}; }
};

/// "lid-slip (fraction 0.1)", for messages.
std::string to_string(const ActiveEffect& active);

/// Effects that touch dry grains, or wet ones.
std::vector<ActiveEffect> touching(const std::vector<ActiveEffect>& effects, bool dry);

/// A condition as the effects on beads and liquid make it: those of type ChangeCondition are
/// applied to it, those on grains are added to its list. Only effects that touch it count. `liquid`
/// is the study's, for a wet condition that has none of its own yet.
EffectiveCondition changed_condition(EffectiveCondition condition,
                                     const std::vector<ActiveEffect>& effects,
                                     const std::optional<Liquid>& liquid);

/// The effects that come with the program, by name: one for each file of sim/effects. Generated by
/// CMake.
const std::vector<Effect>& built_in_effects();

/// The effect of a name among several.
/// @throws std::invalid_argument naming the nearest one
const Effect& effect_named(const std::vector<Effect>& effects, std::string_view name);

/// The built-in effect of a name.
/// @throws std::invalid_argument naming the nearest one
const Effect& built_in_effect(std::string_view name);

/// Values in the units of a run (bead diameter, mass and normal stress are 1) of values in SI units
/// at a normal stress [Pa].
/// @throws std::invalid_argument where the effect is not built in
EffectValues in_run_units(const EffectValues& values, double normal_stress,
                          const GrainProperties& grains);

}  // namespace pendular
