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
#include "sim/closures/level.h"
#include "sim/dem/change_pairs.h"

namespace pendular {

/// An effect on the instrument: a map from the true state of the cell to the state that the
/// instrument shows. Effects on the grains in the cell (`Where::grains`) are applied before effects
/// on the transducers. InstrumentMap combines the maps of all effects and inverts them together.
struct ChangeInstrument {
    std::function<CellState(CellState, const Values&)> show;
    enum class Where { grains, transducers } where = Where::grains;
};

/// An effect that changes properties of the study's grains or liquid, such as the contact angle,
/// and adds no new physics. `change` returns the condition with changed properties; a wet condition
/// that it receives always has its `liquid` set.
struct ChangeCondition {
    std::function<EffectiveCondition(EffectiveCondition, const Values&)> change;
};

/// An effect that replaces one approximation of the closures (analytical formulas for the strength
/// of wet grains) and all approximations of the levels below: the model climbs to `level`, unless
/// it is there already.
struct ChangeClosure {
    closures::Level level = closures::Level::simulation;
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

/// Kind of change that an effect makes: to the instrument, the condition, the forces between
/// grains, the grain sizes, a closure or the flow. Only dem::ChangePairs (forces between grains)
/// and dem::ChangeSample (grain sizes) act inside of a simulation.
using Change = std::variant<ChangeInstrument, ChangeCondition, dem::ChangePairs, dem::ChangeSample,
                            ChangeClosure, ChangeFlow>;

/// Readings that an effect can change: all readings, or only readings of dry grains, of wet grains,
/// or at points of failure.
enum class Touches { all, dry, wet, failure };

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
    /// Whether the effect acts on grains through their capillary forces, so that its change of the
    /// stress ratio and solid fraction is proportional to 1/P* (P* = a^2 s22/F0, the reduced
    /// pressure). False for an effect with forces of its own between wet grains, such as viscosity.
    bool fades_with_capillarity = false;
    /// Property of the liquid that is the effect's parameter. If set, the effect is on in every
    /// study with a liquid, at the value of the property, without being listed. If null, the effect
    /// is off unless the study lists it.
    double Liquid::*given_by_liquid = nullptr;
    /// Quantities of the condition or flow with which the effect's change of the readings grows, as
    /// in "1/normal_stress" for a change that is largest at small normal stress.
    std::vector<std::string> acts_through;
    /// How the parameter can be measured without shearing the grains, as in "a viscometer"; empty
    /// if it cannot.
    std::string directly = {};
    std::vector<std::string> references;

    /// Whether the effect acts on the instrument: it changes the shown state of the cell.
    bool of_instrument() const { return std::holds_alternative<ChangeInstrument>(change); }
    /// Whether the effect changes grain sizes or the forces between grains in the simulation.
    bool of_grains() const;
    /// Whether the effect (ChangeCondition) changes properties of the study's grains or liquid.
    bool of_condition() const { return std::holds_alternative<ChangeCondition>(change); }
    /// Whether the effect is a level of the ladder of closures (analytical formulas for the
    /// strength of wet grains).
    bool of_closure() const { return std::holds_alternative<ChangeClosure>(change); }
    /// Level of the ladder of closures to which the effect takes a model; empty for effects that
    /// change no closure.
    std::optional<closures::Level> level() const {
        return of_closure() ? std::optional(std::get<ChangeClosure>(change).level) : std::nullopt;
    }
    /// Returns the value [unit of the parameter] that the first parameter has where a study does
    /// not list the effect: the property of the liquid (`given_by_liquid`), or else the neutral
    /// value.
    double unlisted_value(const std::optional<Liquid>& liquid) const;
    /// Whether all parameters of the effect are switches, so that there is nothing to fit.
    bool is_switch() const;
    /// Neutral values of the parameters, at which the effect changes nothing, in SI units and in
    /// the order of `parameters`.
    std::vector<double> neutral() const;
    /// Returns the index in `parameters` of the effect's parameter with this name.
    /// @throws std::invalid_argument where there is none, naming the nearest parameter name
    std::size_t parameter(std::string_view parameter_name) const;
};

/// A physical effect with a value for each of its parameters, such as lid slip by 10 %.
struct ActiveEffect {
    const Effect* effect = nullptr;
    std::vector<double> values;  ///< values in SI units, in the order of the effect's parameters

    /// Whether all parameters have their neutral values, so that the effect changes nothing.
    bool is_neutral() const { return values == effect->neutral(); }
    /// Returns a view of the parameter values in SI units, looked up by parameter name. It is valid
    /// as long as this object and `effect` are.
    Values by_name() const { return {effect->parameters, values}; }
};

/// Returns an effect's name and the names and values of its parameters, in the units of
/// `printed_unit`, as text for messages, as in "torque-offset (torque 0.1 mN m)".
std::string to_string(const ActiveEffect& active);

/// Whether an effect can change readings at a condition.
bool touches(const Effect& effect, const Condition& condition);

/// Returns the effects among `effects` that can change readings at a condition.
std::vector<ActiveEffect> touching(const std::vector<ActiveEffect>& effects,
                                   const Condition& condition);

/// Returns a condition as changed by effects. Effects of type ChangeCondition are applied to it,
/// and effects on grains are added to its `grain_effects`, in SI units and sorted by name. Effects
/// on the instrument, on closures and on the flow, and effects on wet grains at a dry condition or
/// the reverse, are ignored. `liquid`: the liquid to use for a wet condition that has no liquid of
/// its own.
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

/// Converts parameter values of an effect on grains from SI units to the reduced units of a
/// simulation at a normal stress [Pa], in which grain diameter, grain mass and normal stress are 1.
/// @throws std::invalid_argument where the effect does not come with the program
EffectValues in_run_units(const EffectValues& values, double normal_stress,
                          const GrainProperties& grains);

}  // namespace pendular
