#pragma once

#include "data/study/effect_tables.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Compiles the effect that a user defines in study.toml ([[effect]]). Each formula gives the
/// value, with the effect, of the quantity that is its key; all formulas read the values without
/// the effect. A quantity without a formula is unchanged. The variables of formulas, in SI units,
/// are the effect's parameter and, depending on what the effect changes (friction_difference:
/// friction coefficient of the grains minus the fitted friction of the model; density and diameter:
/// of the grains):
///     the instrument  torque, normal_force, height, angular_velocity, liquid_content,
///                     bead_volume, time, inner_radius, outer_radius, density, diameter,
///                     normal_stress (normal_force over the area of the annulus)
///     the flow        stress_ratio, solid_fraction, normal_stress, inertial_number,
///                     liquid_content, height, time
///     the condition   friction_difference, surface_tension (0 for dry grains), normal_stress,
///                     inertial_number, liquid_content, height, time
/// The effect is taken to touch only dry grains if its formulas change no wet state among twelve
/// typical states, and only wet grains if its formulas change no dry state among them. The returned
/// effect throws InputError at a formula that gives no finite number.
/// @throws InputError at a formula that cannot be read, does not contain the parameter, changes a
///         quantity although the parameter has the value at which the effect vanishes (key
///         `neutral`), or gives no finite number at a bound of the parameter; at a parameter that
///         has the name of a variable or function
Effect effect_from(const WrittenEffect& written);

}  // namespace pendular
