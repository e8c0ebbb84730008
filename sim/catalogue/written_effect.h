#pragma once

#include "data/study/effect_tables.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Compiles the effect that a user defines in a table [[effect]] of study.toml. The key of a
/// formula is the name of a quantity. The formula computes the value of this quantity with the
/// effect from values of variables without the effect. A quantity without a formula does not
/// change. The variables are the effect's parameter and further quantities in SI units, which
/// depend on what the effect changes:
///     the instrument  torque, normal_force, height, angular_velocity, liquid_content,
///                     bead_volume, time, inner_radius, outer_radius, density, diameter,
///                     normal_stress (normal_force divided by the annulus area)
///     the flow        stress_ratio, solid_fraction, normal_stress, inertial_number,
///                     liquid_content, height, time
///     the condition   friction_difference, surface_tension (0 for dry grains), normal_stress,
///                     inertial_number, liquid_content, height, time
/// Here friction_difference is the friction coefficient between grains minus the fitted friction
/// coefficient of the model. The variables density and diameter are properties of the grains. The
/// formulas are tried on twelve typical states, dry and wet, to find out on which grains the effect
/// acts. If the formulas change dry states but no wet state, the effect counts as an effect on dry
/// grains only. If the formulas change wet states but no dry state, the effect counts as an effect
/// on wet grains only. The returned effect throws InputError at a formula that gives no finite
/// number.
/// @throws InputError at a formula that cannot be read, does not contain the parameter, changes a
///         quantity although the parameter is at its neutral value, gives no finite number at a
///         bound of the parameter, or does not have the unit of its quantity. The unit is checked
///         if the parameter's unit is not 1 and the formula contains no number that may have a
///         dimension.
/// @throws InputError if the parameter has the name of a variable or function
Effect effect_from(const WrittenEffect& written);

}  // namespace pendular
