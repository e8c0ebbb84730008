#pragma once

#include "data/study/effect_tables.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// The effect that a user wrote. Its formulas all read the true state, and each gives the shown
/// value of its key; what has no formula is shown as it is. They know, in SI units, the parameter
/// and
///     of the instrument  torque, normal_force, height, angular_velocity, liquid_content,
///                        bead_volume, time, inner_radius, outer_radius, density, diameter,
///                        normal_stress (normal_force over the area of the annulus)
///     of the beads       stress_ratio, solid_fraction, normal_stress, inertial_number,
///                        liquid_content, height, time
/// It acts on wet readings alone if that is what it does in a few typical states. Where a formula
/// gives no finite number in use, the change ends in an InputError at the formula.
/// @throws InputError at the formula where it cannot be read, does not mention the parameter,
///         changes something at the neutral value, or gives no finite number at a bound; at the
///         parameter where it is called like a variable or function
Effect effect_from(const WrittenEffect& written);

}  // namespace pendular
