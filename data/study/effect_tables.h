#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// Formula of an effect that a user defines in a table [[effect]] of study.toml.
struct Formula {
    std::string target;  ///< quantity that the formula sets, such as "torque"
    std::string text;    ///< text of the formula, not yet compiled
    Position position;   ///< position of the formula in study.toml
};

/// Physical effect that a user defines by formulas in a table [[effect]] of study.toml.
struct WrittenEffect {
    std::string name;  ///< name of the effect, such as "torque-offset"
    /// Name of the effect's parameter. The name is "on" if the effect can only be switched on or
    /// off.
    std::string parameter;
    std::string unit = "1";  ///< SI unit of the effect's parameter; "1": dimensionless
    /// Smallest and largest allowed value of the effect's parameter, in the parameter's unit.
    double lower = 0, upper = 1;
    /// Value of the effect's parameter at which the effect vanishes, in the parameter's unit.
    double neutral = 0;
    /// Smallest difference between the parameter's value and `neutral` that is of interest to the
    /// user, in the parameter's unit. An effect with a smaller difference may be ignored.
    double smallest_of_interest = 1;
    /// Description of the effect in one line; empty if the user gave no description.
    std::string summary = {};
    /// Instrument or method that measures the parameter without shearing grains; empty if the user
    /// stated none.
    std::string measured_by = {};
    /// Standard error that this measurement reaches, in the parameter's unit; 0 if not stated.
    double measured_to = 0;
    std::vector<Formula> formulas;  ///< one formula for each quantity that the effect changes
    Position position;              ///< position of the effect's table [[effect]] in study.toml
    /// Positions of the values of the keys `name` and `parameter` in study.toml.
    Position name_position = {}, parameter_position = {};

    /// Kind of quantities that the formulas of an effect set.
    enum class Kind {
        instrument,  ///< quantities that the instrument shows (`instrument_targets`)
        flow,        ///< quantities of the flow of the grains (`flow_targets`)
        condition    ///< properties of the grains and of their liquid (`condition_targets`)
    };
    /// Returns the kind of quantities that the effect's formulas set. All formulas of one effect
    /// set quantities of one kind.
    Kind kind() const;
};

/// Returns the names of the quantities shown by the instrument that formulas in a table [[effect]]
/// of study.toml can set: "torque" [N m], "normal_force" [N], "height" of the sample [m] and
/// "angular_velocity" of the lid [rad/s]. An effect that sets one of these quantities cannot also
/// set `flow_targets` or `condition_targets`.
const std::vector<std::string>& instrument_targets();
/// Returns the names of the quantities of the flow that formulas in a table [[effect]] of
/// study.toml can set: "stress_ratio" [1] and "solid_fraction" [1].
const std::vector<std::string>& flow_targets();
/// Returns the names of the properties of grains and liquid that formulas in a table [[effect]] of
/// study.toml can set: "friction_difference" [1] and "surface_tension" [N/m]. The friction
/// difference is the friction coefficient between grains minus the fitted friction coefficient of
/// the model.
const std::vector<std::string>& condition_targets();

/// Reads the effects that a user defines in the tables [[effect]] of study.toml, in the order of
/// the file.
/// @param root top level of study.toml
/// @throws InputError if a key is missing, unknown or has an invalid value, if two effects have
///         equal names, if an effect has no formula, or if an effect has formulas for quantities of
///         two kinds (`WrittenEffect::Kind`)
std::vector<WrittenEffect> read_written_effects(const StudyTable& root);

}  // namespace pendular
