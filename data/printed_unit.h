#pragma once

#include <string>

#include "data/effect_parameter.h"

namespace pendular {

/// Unit in which values of a quantity are printed, with the size of the unit in the quantity's SI
/// unit.
struct PrintedUnit {
    std::string name;  ///< name of the printed unit, such as "mN m"; "1": dimensionless
    double si = 1;     ///< size of one printed unit in the SI unit: 0.001 for "mN m"
};

/// Returns the unit in which all values of a parameter of a physical effect are printed. An angle
/// is printed in degrees. Every other parameter is printed in its SI unit. The SI unit gets the
/// prefix m (milli) if both bounds of the parameter are below 1 in magnitude, and u (micro) if both
/// bounds are below 0.001. Numbers without dimension, and units such as "kg" and "m^2", get no
/// prefix.
PrintedUnit printed_unit(const EffectParameter& parameter);

/// Returns a value [SI unit] of an effect's parameter as text in the printed unit (`printed_unit`),
/// with four significant digits, such as "0.1 mN m" or "10 deg". The text has no unit if the
/// parameter is dimensionless.
std::string printed_value(double value, const EffectParameter& parameter);

/// Returns a value [SI unit] of an effect's parameter as one argument of a shell command, in the
/// printed unit (`printed_unit`). If the value has a unit, the text is in double quotes, which are
/// part of the text: "10 deg".
std::string printed_word(double value, const EffectParameter& parameter);

/// Returns the lower and upper bound of an effect's parameter as text in the printed unit
/// (`printed_unit`), such as "-100 to 100 mN m".
std::string printed_bounds(const EffectParameter& parameter);

}  // namespace pendular
