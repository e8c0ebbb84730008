#pragma once

#include "data/study/effect_tables.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Compiles the effect that a user defines by formulas in a table [[effect]] of study.toml. Each
/// formula computes a new value for the quantity that the key of the formula names. All variables
/// have their values without the effect. Quantities without a formula do not change. The variables
/// are the parameter of the effect and, in SI units, the quantities in one line of the following
/// list. The line depends on what the effect changes:
///     the instrument  torque, normal_force, height, angular_velocity, liquid_content,
///                     bead_volume, time, inner_radius, outer_radius, density, diameter,
///                     normal_stress (normal_force divided by the annulus area)
///     the flow        stress_ratio, solid_fraction, normal_stress, inertial_number,
///                     liquid_content, height, time
///     the condition   friction_difference, surface_tension (0 for dry grains), normal_stress,
///                     inertial_number, liquid_content, height, time
/// The variable friction_difference is the friction coefficient between grains minus the fitted
/// friction coefficient of the model. The variables density and diameter are properties of the
/// grains.
///
/// The function tries the formulas on typical dry and wet states. If the formulas change only dry
/// states, the effect acts on dry grains only. If the formulas change only wet states, the effect
/// acts on wet grains only. The returned effect throws InputError if a formula gives no finite
/// number.
/// @throws InputError if a formula cannot be read, does not contain the parameter, changes a
///         quantity at the neutral value of the parameter, or gives no finite number at a bound of
///         the parameter
/// @throws InputError if a formula does not have the unit of its quantity; the unit is checked if
///         the parameter's unit is not 1 and if the formula contains no number that may have a
///         dimension
/// @throws InputError if the parameter has the name of a variable or function
Effect effect_from(const WrittenEffect& written);

}  // namespace pendular
