#pragma once

#include <string>

#include "data/effect_parameter.h"

namespace pendular {

/// Unit in which a quantity is printed, a multiple of its SI unit.
struct PrintedUnit {
    std::string name;  ///< name of the printed unit, such as "mN m"; "1": dimensionless
    double si = 1;     ///< size of one printed unit in the SI unit: 0.001 for "mN m"
};

/// Unit in which all values of an effect's parameter are printed. An angle is printed in degrees.
/// Otherwise the unit is the parameter's SI unit, with the prefix m if both bounds of the parameter
/// are below 1 in magnitude, or u if both are below 0.001: "mN m" for torques up to 0.1 N m.
PrintedUnit printed_unit(const EffectParameter& parameter);

/// Text of a value [SI unit] of an effect's parameter with four significant digits in its printed
/// unit (`printed_unit`): "0.1 mN m", "10 deg"; without a unit if the parameter is dimensionless.
std::string printed_value(double value, const EffectParameter& parameter);

/// Text of a value [SI unit] of an effect's parameter as `printed_value` gives it, for use as one
/// argument of a command: in quotes if it contains a unit.
std::string printed_word(double value, const EffectParameter& parameter);

/// Text of the bounds of an effect's parameter in its printed unit: "-100 to 100 mN m".
std::string printed_bounds(const EffectParameter& parameter);

}  // namespace pendular
