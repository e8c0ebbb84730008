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

/// An effect on the instrument: a map from the true state of the cell to the state that the
/// instrument shows. Effects on the grains in the cell (`Where::grains`) are applied before effects
/// on the transducers. InstrumentMap inverts all maps together.
struct ChangeInstrument {
    std::function<CellState(CellState, const Values&)> show;
    enum class Where { grains, transducers } where = Where::grains;
};

/// An effect that changes properties of the study's grains or liquid, such as the contact angle,
/// and adds no new physics. `change` receives a wet condition with its liquid filled in.
struct ChangeCondition {
    std::function<EffectiveCondition(EffectiveCondition, const Values&)> change;
};

/// An effect that adds a term to the closures (analytical formulas) of a base model.
struct ChangeClosure {
    std::string base;                       ///< base model with the closure, as in "rumpf"
    bool closures::Terms::*term = nullptr;  ///< term that the effect switches on
};

/// Stress ratio mu* [1] and solid fraction Phi_S [1] of a state of steady shear.
struct FlowPoint {
    double stress_ratio = 0, solid_fraction = 0;
};

/// An effect that a user's formulas define directly as a change of the stress ratio and solid
/// fraction at a condition, without a physical mechanism.
struct ChangeFlow {
    std::function<FlowPoint(FlowPoint, const Condition&, const Values&)> change;
};

/// Change that an effect makes. Only dem::ChangePairs (forces between grains) and dem::ChangeSample
/// (grain sizes) act inside of a simulation.
using Change = std::variant<ChangeInstrument, ChangeCondition, dem::ChangePairs, dem::ChangeSample,
                            ChangeClosure, ChangeFlow>;

/// Readings that an effect can change: all readings, or only readings of dry grains or of wet
/// grains.
enum class Touches { all, dry, wet };

/// A physical effect that may be missing from a model, with everything that the program knows about
/// it. Each built-in effect is defined in one file of sim/effects and has the name of that file;
/// CMake collects the files.
struct Effect {
    std::string name = {};  ///< name of the effect, as in "torque-offset"
    std::string summary;    ///< summary in one line
    std::string equation;   ///< equation and its validity, for the manual; lines of text
    std::vector<EffectParameter> parameters;
    Change change;
    Touches touches = Touches::all;
    /// Whether the effect acts on grains through their capillary forces, so that the change of the
    /// flow is proportional to 1/P*. False for an effect that brings its own forces between wet
    /// grains, such as viscosity.
    bool fades_with_capillarity = false;
    /// Property of the liquid that is the effect's parameter. If set, the effect is on in every
    /// study with a liquid, at the value of the property, without being listed. If null, the effect
    /// is off unless the study lists it.
    double Liquid::*given_by_liquid = nullptr;
    /// Covariates with which the effect's change of the readings grows, as in "1/normal_stress".
    std::vector<std::string> acts_through;
    /// How the parameter can be measured without shearing the grains, as in "a viscometer"; empty
    /// if it cannot.
    std::string directly = {};
    std::vector<std::string> references;

    /// Whether the effect changes what the instrument shows.
    bool of_instrument() const { return std::holds_alternative<ChangeInstrument>(change); }
    /// Whether the effect changes grain sizes or the forces between grains in the simulation.
    bool of_grains() const;
    /// Whether the effect changes properties of the study's grains or liquid.
    bool of_condition() const { return std::holds_alternative<ChangeCondition>(change); }
    /// Whether the effect adds a term to the closures of a base model.
    bool of_closure() const { return std::holds_alternative<ChangeClosure>(change); }
    /// Name of the base model whose closure the effect changes; empty for other effects.
    std::string base() const { return of_closure() ? std::get<ChangeClosure>(change).base : ""; }
    /// Returns the value [unit of the parameter] that the first parameter has where a study does
    /// not list the effect: the property of the liquid (`given_by_liquid`), or else the neutral
    /// value.
    double unlisted_value(const std::optional<Liquid>& liquid) const;
    /// Whether all parameters of the effect are switches, so that there is nothing to fit.
    bool is_switch() const;
    /// Neutral values of the parameters, at which the effect changes nothing, in SI units.
    std::vector<double> neutral() const;
    /// Returns the index of the parameter with this name.
    /// @throws std::invalid_argument where there is none, naming the nearest parameter name
    std::size_t parameter(std::string_view parameter_name) const;
};

/// An effect with the values of its parameters.
struct ActiveEffect {
    const Effect* effect = nullptr;
    std::vector<double> values;  ///< values in SI units, in the order of the effect's parameters

    /// Whether all parameters have their neutral values, so that the effect changes nothing.
    bool is_neutral() const { return values == effect->neutral(); }
    /// Returns a view of the values by parameter name.
    Values by_name() const { return {effect->parameters, values}; }
};

/// Returns an effect and its values as text for messages, as in "lid-slip (fraction 0.1)".
std::string to_string(const ActiveEffect& active);

/// Returns the effects among `effects` that change readings of dry grains if `dry`, else of wet
/// grains.
std::vector<ActiveEffect> touching(const std::vector<ActiveEffect>& effects, bool dry);

/// Returns a condition as changed by effects: effects of type ChangeCondition are applied to it,
/// and effects on grains are added to its `grain_effects`. Effects that do not touch the condition,
/// which is dry or wet, are ignored. `liquid`: the study's liquid, for a wet condition without a
/// liquid of its own.
EffectiveCondition changed_condition(EffectiveCondition condition,
                                     const std::vector<ActiveEffect>& effects,
                                     const std::optional<Liquid>& liquid);

/// Effects that come with the program, sorted by name, one for each file of sim/effects. CMake
/// generates this function.
const std::vector<Effect>& built_in_effects();

/// Returns the effect with this name among `effects`.
/// @throws std::invalid_argument where there is none, naming the effect with the nearest name
const Effect& effect_named(const std::vector<Effect>& effects, std::string_view name);

/// Returns the effect with this name that comes with the program.
/// @throws std::invalid_argument where there is none, naming the effect with the nearest name
const Effect& built_in_effect(std::string_view name);

/// Returns values of an effect on grains, given in SI units, in the units of a run at a normal
/// stress [Pa]. In these units grain diameter, grain mass and normal stress are 1.
/// @throws std::invalid_argument where the effect does not come with the program
EffectValues in_run_units(const EffectValues& values, double normal_stress,
                          const GrainProperties& grains);

}  // namespace pendular
