#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// Formula of an effect: sets one quantity from the others.
struct Formula {
    std::string target;  ///< quantity that the formula sets, such as "torque"
    std::string text;    ///< not yet compiled
    Position position;
};

/// Effect that a user defines by formulas in a table [[effect]] of study.toml. Numbers are in the
/// parameter's `unit`.
struct WrittenEffect {
    std::string name;             ///< such as "torque-offset"
    std::string parameter;        ///< "on" for an effect that can only be switched on or off
    std::string unit = "1";       ///< SI unit; "1": dimensionless
    double lower = 0, upper = 1;  ///< smallest and largest allowed value
    double neutral = 0;           ///< value at which the effect vanishes
    /// Smallest effect of interest, as a difference from `neutral`.
    double smallest_of_interest = 1;
    std::string summary = {};       ///< description in one line; may be empty
    std::string measured_by = {};   ///< method of a direct measurement; empty: none stated
    double measured_to = 0;         ///< standard error of that measurement; 0: not stated
    std::vector<Formula> formulas;  ///< one for each quantity that the effect changes
    Position position;
    Position name_position = {}, parameter_position = {};

    /// Kind of the quantities that the formulas set: `instrument_targets`, `flow_targets` or
    /// `condition_targets`. It is the same for all formulas of one effect.
    enum class Kind { instrument, flow, condition };
    Kind kind() const;
};

/// Returns the quantities shown by the instrument that formulas can set: "torque" [N m],
/// "normal_force" [N], "height" of the sample [m] and "angular_velocity" of the lid [rad/s].
const std::vector<std::string>& instrument_targets();
/// Returns the quantities of the flow that formulas can set: "stress_ratio" [1] and
/// "solid_fraction" [1].
const std::vector<std::string>& flow_targets();
/// Returns the properties of grains and liquid that formulas can set: "friction_difference" [1],
/// the friction coefficient between grains minus the fitted one, and "surface_tension" [N/m].
const std::vector<std::string>& condition_targets();

/// Reads the tables [[effect]] of study.toml, in the order of the file.
/// @throws InputError if a key is missing, unknown or has an invalid value, if two effects have
///         equal names, or if an effect has no formula or formulas of two `WrittenEffect::Kind`
std::vector<WrittenEffect> read_written_effects(const StudyTable& root);

}  // namespace pendular
