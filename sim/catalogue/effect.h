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

/// Effect on the instrument. The function `show` receives a true state of the cell and returns the
/// state that the instrument shows. Effects on the grains in the cell (`Where::grains`), such as
/// wall friction, are applied before effects on the transducers, such as a torque offset.
/// `InstrumentMap` combines the functions of all effects and inverts the combination.
struct ChangeInstrument {
    std::function<CellState(CellState, const Values&)> show;
    enum class Where { grains, transducers } where = Where::grains;
};

/// Effect that changes only properties of the study's grains or liquid, such as the contact angle.
/// The function `change` receives a condition and returns the condition with changed properties. A
/// wet condition is passed to the function with the member `liquid` set.
struct ChangeCondition {
    std::function<EffectiveCondition(EffectiveCondition, const Values&)> change;
};

/// Effect that makes a model compute the strength (stress ratio) of wet grains by a more accurate
/// method. The method is the formula (closure) or the simulation that `level` names. The levels are
/// ordered from the simplest formula to the simulation. A model that already uses a higher level is
/// not changed.
struct ChangeClosure {
    closures::Level level = closures::Level::simulation;
};

/// Stress ratio [1] and solid fraction [1] of a state of steady shear.
struct FlowPoint {
    double stress_ratio = 0, solid_fraction = 0;
};

/// Effect on the stress ratio and the solid fraction that a model predicts. The function `change`
/// receives the stress ratio and the solid fraction without the effect, and the condition (normal
/// stress, inertial number and liquid content). The function returns the two values with the
/// effect. Effects of this kind are `peak-strength` and the effects that a user defines by formulas
/// for the flow.
struct ChangeFlow {
    std::function<FlowPoint(FlowPoint, const Condition&, const Values&)> change;
};

/// Way in which an effect acts on a model. The effect changes the instrument, the condition, the
/// forces between grains (`dem::ChangePairs`), the grain sizes (`dem::ChangeSample`), a closure
/// (formula for the strength of wet grains), or the predicted stress ratio and solid fraction
/// (`ChangeFlow`). Only effects on forces and on grain sizes act inside a simulation.
using Change = std::variant<ChangeInstrument, ChangeCondition, dem::ChangePairs, dem::ChangeSample,
                            ChangeClosure, ChangeFlow>;

/// Kind of readings that an effect can change: all readings, or only readings of dry grains, of wet
/// grains, or at points of failure (peaks of the shear stress).
enum class Touches { all, dry, wet, failure };

/// Physical effect that a model may lack, with its description, its parameters and the way in which
/// it acts on a model. Each built-in effect is defined in the file of sim/effects that has the name
/// of the effect. CMake collects these files.
struct Effect {
    std::string name = {};  ///< name of the effect, such as "torque-offset"
    std::string summary;    ///< description of the effect in one line
    /// Equation of the effect and range of validity of the equation, as lines of text for the
    /// manual.
    std::string equation;
    std::vector<EffectParameter> parameters;
    Change change;
    Touches touches = Touches::all;
    /// Whether the effect acts through the capillary forces between grains. The program then
    /// assumes that the effect changes stress ratio and solid fraction in proportion to 1/(reduced
    /// pressure). The member is false for an effect with forces of its own between wet grains, such
    /// as viscosity.
    bool fades_with_capillarity = false;
    /// Property of the liquid that is the effect's parameter, such as the surface tension. If this
    /// member is set, the effect acts in every study with a liquid, with the liquid's value,
    /// without being listed. If this member is null, the effect acts only if the study lists the
    /// effect.
    double Liquid::*given_by_liquid = nullptr;
    /// Names of the quantities on which the change of the readings by the effect depends, such as
    /// "time", or "1/normal_stress" for a change that is largest at small normal stress.
    std::vector<std::string> acts_through;
    /// Instrument or method that measures the effect's parameter without shearing grains, such as
    /// "a viscometer"; empty if none is known.
    std::string directly = {};
    /// Standard error that this measurement reaches, in the parameter's unit; 0 if unknown.
    double reachable_error = 0;
    std::vector<std::string> references;  ///< publications that describe the effect

    /// Whether the effect acts on the instrument, so that it changes the state of the cell that the
    /// instrument shows.
    bool of_instrument() const { return std::holds_alternative<ChangeInstrument>(change); }
    /// Whether the effect changes grain sizes or the forces between grains in the simulation.
    bool of_grains() const;
    /// Whether the effect changes properties of the study's grains or liquid (`ChangeCondition`).
    bool of_condition() const { return std::holds_alternative<ChangeCondition>(change); }
    /// Whether the effect makes a model compute the strength of wet grains by a more accurate
    /// formula (closure) or by simulation (`ChangeClosure`).
    bool of_closure() const { return std::holds_alternative<ChangeClosure>(change); }
    /// Returns the level of accuracy (`closures::Level`) to which the effect raises a model's
    /// formula (closure) for the strength of wet grains; empty if the effect does not change this
    /// formula.
    std::optional<closures::Level> level() const {
        return of_closure() ? std::optional(std::get<ChangeClosure>(change).level) : std::nullopt;
    }
    /// Returns the value of the effect's first parameter, in the parameter's unit, in a study that
    /// does not list the effect. The value is the property of the liquid (`given_by_liquid`) or,
    /// without such a property, the neutral value, at which the effect changes nothing.
    double unlisted_value(const std::optional<Liquid>& liquid) const;
    /// Whether all parameters of the effect are switches (on or off), so that no value can be
    /// fitted.
    bool is_switch() const;
    /// Returns the neutral value of each parameter of the effect in SI units, in the order of
    /// `parameters`. The effect changes nothing at the neutral values.
    std::vector<double> neutral() const;
    /// Returns the index, in the effect's list `parameters`, of the parameter with a given name.
    /// @throws std::invalid_argument if the effect has no parameter with this name; the message
    ///         suggests the nearest name
    std::size_t parameter(std::string_view parameter_name) const;
};

/// Physical effect with a value for each of its parameters, such as lid slip by 10 %.
struct ActiveEffect {
    const Effect* effect = nullptr;
    /// Value of each parameter of the effect in SI units, in the order of `Effect::parameters`.
    std::vector<double> values;

    /// Whether all parameters of the effect have their neutral values, so that the effect changes
    /// nothing.
    bool is_neutral() const { return values == effect->neutral(); }
    /// Returns the values of the effect's parameters in SI units, accessed by parameter name. This
    /// object and `effect` must outlive the returned object.
    Values by_name() const { return {effect->parameters, values}; }
};

/// Returns an effect as text for messages, such as "torque-offset (torque 0.1 mN m)". The text
/// consists of the name of the effect and of the names and values of its parameters, in the units
/// in which the program prints them (`printed_unit`).
std::string to_string(const ActiveEffect& active);

/// Whether an effect can change readings at a condition. Some effects change only readings of dry
/// grains, of wet grains, or at points of failure (`Effect::touches`).
bool touches(const Effect& effect, const Condition& condition);

/// Returns the effects of a list that can change readings at a given condition, in the order of the
/// list.
std::vector<ActiveEffect> touching(const std::vector<ActiveEffect>& effects,
                                   const Condition& condition);

/// Applies effects to a condition and returns the changed condition. Effects of type
/// `ChangeCondition` change the properties of grains and liquid. Effects on grains are added to the
/// list `grain_effects` of the condition, in SI units. The list is sorted by name. The function
/// ignores all other effects, and effects that cannot act at the condition (`touches`).
/// @param liquid liquid of a wet condition that has no liquid of its own
EffectiveCondition changed_condition(EffectiveCondition condition,
                                     const std::vector<ActiveEffect>& effects,
                                     const std::optional<Liquid>& liquid);

/// Returns all effects that come with the program, sorted by name, one for each file of
/// sim/effects. CMake generates this function.
const std::vector<Effect>& built_in_effects();

/// Returns the effect with a given name from a list of effects.
/// @throws std::invalid_argument if no effect has this name; the message suggests the nearest name
const Effect& effect_named(const std::vector<Effect>& effects, std::string_view name);

/// Returns the built-in effect with a given name.
/// @throws std::invalid_argument if no effect has this name; the message suggests the nearest name
const Effect& built_in_effect(std::string_view name);

/// Converts parameter values of an effect on grains from SI units to the reduced units of a
/// simulation, in which grain diameter, grain mass and normal stress are 1.
/// @param normal_stress normal stress of the simulated condition [Pa]
/// @throws std::invalid_argument if the effect is not built in
EffectValues in_run_units(const EffectValues& values, double normal_stress,
                          const GrainProperties& grains);

}  // namespace pendular
