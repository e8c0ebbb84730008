#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/catalogue/formula.h"

namespace pendular {

/// SI units in a formula: unit of the result (`target`) and units of the variables, in the order of
/// the variables. The last variable is the parameter of an effect, whose unit is to be checked.
struct FormulaUnits {
    std::string target;
    std::vector<std::string> variables;
};

/// Checks whether the unit of a formula's last variable makes the formula dimensionally
/// homogeneous, so that the formula holds in every system of units of mass, length and time. Angles
/// count as dimensionless. If the unit is wrong, the function returns the SI unit that the variable
/// should have, or an empty text if no unit makes the formula homogeneous. The function returns an
/// empty optional if the unit is right or nothing could be checked.
/// @param text text of the formula; nothing is checked if it contains numbers that may have a
///         dimension (limits in comparisons, and all numbers except 0, 1 and powers)
/// @param values values of the variables in SI units, one list for each of several typical states
std::optional<std::string> better_unit(const CompiledFormula& formula, const std::string& text,
                                       const FormulaUnits& units,
                                       const std::vector<std::vector<double>>& values);

}  // namespace pendular
