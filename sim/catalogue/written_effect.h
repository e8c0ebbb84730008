#pragma once

#include "data/study/effect_tables.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Returns the effect that a user defines by formulas in a table [[effect]] of study.toml. Each
/// formula gives the new value of the quantity that its key names, from the values without the
/// effect. Quantities without a formula do not change. Variables are the effect's parameter and, in
/// SI units, those of one line, by what the effect changes:
///     the instrument  torque, normal_force, height, angular_velocity, liquid_content,
///                     bead_volume, time, inner_radius, outer_radius, density, diameter,
///                     normal_stress (normal_force divided by the annulus area)
///     the flow        stress_ratio, solid_fraction, normal_stress, inertial_number,
///                     liquid_content, height, time
///     the condition   friction_difference, surface_tension (0 for dry grains), normal_stress,
///                     inertial_number, liquid_content, height, time
/// The friction_difference is the friction coefficient minus the fitted one of the model; density
/// and diameter are those of the grains.
///
/// The formulas are tried on typical dry and wet states: if they change only dry or only wet ones,
/// the effect acts on these grains only. The returned effect throws InputError if a formula gives
/// no finite number.
/// @throws InputError if a formula cannot be read, does not contain the parameter, changes a
///         quantity at the parameter's neutral value, or gives no finite number at a bound of the
///         parameter; if a formula lacks the unit of its quantity (checked unless the parameter's
///         unit is 1 or the formula contains a number that may have a dimension); if the parameter
///         has the name of a variable or function
Effect effect_from(const WrittenEffect& written);

}  // namespace pendular
