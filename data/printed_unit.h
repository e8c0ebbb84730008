#pragma once

#include <string>

#include "data/effect_parameter.h"

namespace pendular {

/// Unit in which a quantity is printed, a multiple of its SI unit.
struct PrintedUnit {
    std::string name;  ///< name of the printed unit, such as "mN m"; "1": dimensionless
    double si = 1;     ///< size of one printed unit in the SI unit: 0.001 for "mN m"
};

/// Unit in which the values of an effect's parameter are printed for readers, the same for all its
/// values: degrees for an angle, else the parameter's SI unit with the prefix m or u if the bounds
/// of the parameter are all below 1 or 0.001 of the SI unit, "mN m" for torques up to 0.1 N m.
PrintedUnit printed_unit(const EffectParameter& parameter);

/// Text of a value [SI unit] of an effect's parameter with four significant digits in its printed
/// unit (`printed_unit`): "0.1 mN m", "10 deg"; without a unit if the parameter is dimensionless.
std::string printed_value(double value, const EffectParameter& parameter);

/// Text of `printed_value` as one word of a command line: in quotes if it has a unit.
std::string printed_word(double value, const EffectParameter& parameter);

/// Text of the bounds of an effect's parameter in its printed unit: "-100 to 100 mN m".
std::string printed_bounds(const EffectParameter& parameter);

}  // namespace pendular
