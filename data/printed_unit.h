#pragma once

#include <string>

#include "data/effect_parameter.h"

namespace pendular {

/// Unit in which values of a quantity are printed.
struct PrintedUnit {
    std::string name;  ///< such as "mN m"; "1": dimensionless
    double si = 1;     ///< size of one printed unit in the SI unit: 0.001 for "mN m"
};

/// Returns the unit in which all values of a parameter are printed: degrees for an angle, otherwise
/// its SI unit, with the prefix m if both bounds are below 1 in magnitude and u if both are below
/// 0.001. Numbers without dimension, and units such as "kg" and "m^2", get no prefix.
PrintedUnit printed_unit(const EffectParameter& parameter);

/// Returns a value [SI unit] in the printed unit with four significant digits, such as "0.1 mN m"
/// or "10 deg", or "0.3" for a dimensionless parameter.
std::string printed_value(double value, const EffectParameter& parameter);

/// Returns `printed_value` as one argument of a shell command: a text with a unit is in double
/// quotes, which are part of the text.
std::string printed_word(double value, const EffectParameter& parameter);

/// Returns the bounds of a parameter in the printed unit, such as "-100 to 100 mN m".
std::string printed_bounds(const EffectParameter& parameter);

}  // namespace pendular
