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
#include "sim/closures/level.h"
#include "sim/dem/change_pairs.h"

namespace pendular {

/// State of an annular shear cell: the true state, or the state that the instrument shows. Torque
/// is positive when it shears the grains, normal force when it compresses them.
struct CellState {
    double torque = 0;            ///< on the lid [N m]
    double normal_force = 0;      ///< on the sample at mid-height [N]
    double height = 0;            ///< of the sample [m]
    double angular_velocity = 0;  ///< of the lid [rad/s]
    double liquid_content = 0;    ///< liquid volume over grain volume [1]
    double bead_volume = 0;       ///< solid volume of the grains [m^3]
    double time = 0;              ///< since the study's first recording began [s]

    // No effect changes the quantities below.
    double inner_radius = 0, outer_radius = 0;  ///< of the side walls [m]
    double density = 0;                         ///< of the grain material [kg/m^3]
    double diameter = 0;                        ///< mean diameter of the grains [m]

    /// Returns the area of the annulus on which the lid presses [m^2].
    double area() const;
    /// Returns the torque [N m] of a uniform shear stress [Pa] on that annulus.
    double torque_of(double shear_stress) const;
    /// Returns the distance between the side walls [m].
    double width() const { return outer_radius - inner_radius; }
    /// Returns the weight of the dry grains in the cell [N].
    double weight() const;
};

/// Condition that is truly imposed on the grains, with the properties of grains and liquid after
/// all effects on them. Without effects, it equals the condition that the study states.
struct EffectiveCondition : Condition {
    EffectiveCondition() = default;
    EffectiveCondition(const Condition& imposed) : Condition(imposed) {}

    std::optional<Liquid> liquid;    ///< after effects; empty: the liquid of the study
    double friction_difference = 0;  ///< friction coefficient minus that of the study's model [1]
    std::vector<EffectValues> grain_effects;  ///< those a simulation must contain, in SI units

    bool operator==(const EffectiveCondition&) const = default;
};

/// Returns conditions on which no effect acts, in the order of `conditions`.
inline std::vector<EffectiveCondition> without_effects(const std::vector<Condition>& conditions) {
    return {conditions.begin(), conditions.end()};
}

/// Effect on the instrument: `show` returns the state that the instrument shows for a true state of
/// the cell. Effects on the grains in the cell, such as wall friction, act before effects on the
/// transducers, such as a torque offset. `InstrumentMap` combines all effects and inverts the
/// combination.
struct ChangeInstrument {
    std::function<CellState(CellState, const Values&)> show;
    /// `table`: on the stresses and solid fractions of tables of readings, in studies without a
    /// cell, whose instrument is not known.
    enum class Where { grains, transducers, table } where = Where::grains;
};

/// Effect that changes only properties of the study's grains or liquid, such as the contact angle.
/// `change` receives wet conditions with the member `liquid` set.
struct ChangeCondition {
    std::function<EffectiveCondition(EffectiveCondition, const Values&)> change;
};

/// Effect that makes a model compute the strength of wet grains by the formula or simulation that
/// `level` names. A model that already uses a higher level is not changed.
struct ChangeClosure {
    closures::Level level = closures::Level::simulation;
};

/// Stress ratio [1] and solid fraction [1] of a state of steady shear.
struct FlowPoint {
    double stress_ratio = 0, solid_fraction = 0;
};

/// Effect on the stress ratio and solid fraction that a model predicts at a condition:
/// `peak-strength` and the effects that a user defines by formulas for the flow.
struct ChangeFlow {
    std::function<FlowPoint(FlowPoint, const Condition&, const Values&)> change;
};

/// Way in which an effect acts. Only effects on forces (`dem::ChangePairs`) and on grain sizes
/// (`dem::ChangeSample`) act inside a simulation.
using Change = std::variant<ChangeInstrument, ChangeCondition, dem::ChangePairs, dem::ChangeSample,
                            ChangeClosure, ChangeFlow>;

/// Readings that an effect can change: all, or only those of dry grains, of wet grains, or at
/// points of failure.
enum class Touches { all, dry, wet, failure };

/// Physical effect that a model may lack. Each built-in effect is defined in the file of
/// sim/effects that has its name; CMake collects these files.
struct Effect {
    std::string name = {};  ///< such as "torque-offset"
    std::string summary;    ///< one line
    std::string equation;   ///< equation and its range of validity, as lines of the manual
    std::vector<EffectParameter> parameters;
    Change change;
    Touches touches = Touches::all;
    /// Whether the effect acts through the capillary forces between grains. The program then
    /// assumes that its change of stress ratio and solid fraction is proportional to
    /// 1/(reduced pressure). False for an effect with forces of its own, such as viscosity.
    bool fades_with_capillarity = false;
    /// Property of the liquid that is the effect's parameter, such as the surface tension. If set,
    /// the effect acts in every study with a liquid, with the liquid's value, without being listed.
    double Liquid::*given_by_liquid = nullptr;
    /// Whether a diagnosis tries the effect only where the bed may not be sheared throughout: if
    /// the study states a friction of the side walls, or the gap creeps in a reading. Elsewhere it
    /// would explain what wall friction of an evenly sheared bed explains. A study may list it
    /// anyway.
    bool of_uneven_shear = false;
    /// Quantities on which the change of the readings depends, such as "time", or "1/normal_stress"
    /// for a change that is largest at small normal stress.
    std::vector<std::string> acts_through;
    std::string directly = {};   ///< what measures the parameter directly, such as "a viscometer"
    double reachable_error = 0;  ///< standard error of `directly` in the parameter's unit
    /// Why the effect is there without being measured, as a clause; empty: it may be absent.
    std::string certain = {};
    std::vector<std::string> references;

    bool of_instrument() const { return std::holds_alternative<ChangeInstrument>(change); }
    /// Whether the effect acts on tables of readings in studies without a cell.
    bool of_table() const;
    /// Whether the effect changes grain sizes or the forces between grains.
    bool of_grains() const;
    bool of_condition() const { return std::holds_alternative<ChangeCondition>(change); }
    bool of_closure() const { return std::holds_alternative<ChangeClosure>(change); }
    /// Returns the level to which the effect raises a model; empty for effects of another kind.
    std::optional<closures::Level> level() const {
        return of_closure() ? std::optional(std::get<ChangeClosure>(change).level) : std::nullopt;
    }
    /// Returns the first parameter's value, in its unit, in a study that does not list the effect:
    /// the property of the liquid (`given_by_liquid`), or else the neutral value.
    double unlisted_value(const std::optional<Liquid>& liquid) const;
    /// Whether all parameters are switches, so that no value can be fitted.
    bool is_switch() const;
    /// Returns the values of `parameters`, in SI units, at which the effect changes nothing.
    std::vector<double> neutral() const;
    /// Returns the index of a parameter in `parameters`.
    /// @throws std::invalid_argument if there is none of this name; the message suggests the
    ///         nearest name
    std::size_t parameter(std::string_view parameter_name) const;
};

/// Effect with a value for each of its parameters, such as lid slip by 10 %.
struct ActiveEffect {
    const Effect* effect = nullptr;
    std::vector<double> values;  ///< in SI units, in the order of `Effect::parameters`

    /// Whether all parameters have their neutral values, at which the effect changes nothing.
    bool is_neutral() const { return values == effect->neutral(); }
    /// Returns the values by parameter name. This object and `effect` must outlive the result.
    Values by_name() const { return {effect->parameters, values}; }
};

/// Returns an effect as text for messages, such as "torque-offset (torque 0.1 mN m)", with values
/// in the units in which the program prints them (`printed_unit`).
std::string to_string(const ActiveEffect& active);

/// Whether an effect can change readings at a condition (`Effect::touches`).
bool touches(const Effect& effect, const Condition& condition);

/// Returns the effects that can change readings at a condition, in the order of `effects`.
std::vector<ActiveEffect> touching(const std::vector<ActiveEffect>& effects,
                                   const Condition& condition);

/// Returns a condition after the effects that can act at it: effects of type `ChangeCondition`
/// change properties of grains and liquid, effects on grains are added to `grain_effects`, which is
/// sorted by name. All other effects are ignored.
/// @param liquid liquid of a wet condition that has no liquid of its own
EffectiveCondition changed_condition(EffectiveCondition condition,
                                     const std::vector<ActiveEffect>& effects,
                                     const std::optional<Liquid>& liquid);

/// Returns all effects that come with the program, sorted by name. CMake generates this function.
const std::vector<Effect>& built_in_effects();

/// Returns the effect of a given name from a list.
/// @throws std::invalid_argument if there is none of this name; the message suggests the nearest
///         name
const Effect& effect_named(const std::vector<Effect>& effects, std::string_view name);

/// Returns the built-in effect of a given name.
/// @throws std::invalid_argument if there is none of this name; the message suggests the nearest
///         name
const Effect& built_in_effect(std::string_view name);

/// Returns parameter values of an effect on grains, given in SI units, in the reduced units of a
/// simulation, in which grain diameter, grain mass and normal stress are 1.
/// @param normal_stress of the simulated condition [Pa]
/// @throws std::invalid_argument if the effect is not built in
EffectValues in_run_units(const EffectValues& values, double normal_stress,
                          const GrainProperties& grains);

}  // namespace pendular
