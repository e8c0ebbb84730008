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

/// Checks whether a formula is dimensionally homogeneous if its last variable has the stated unit.
/// Angles count as dimensionless. Returns an empty optional if the unit is right or cannot be
/// checked. Otherwise returns the SI unit that makes the formula homogeneous, or an empty text if
/// no unit does.
/// @param text text of the formula; a formula with comparisons, or with numbers other than 0, 1 and
///         exponents, cannot be checked, since such numbers may have a dimension
/// @param values values of the variables in SI units, one list for each of several typical states
std::optional<std::string> better_unit(const CompiledFormula& formula, const std::string& text,
                                       const FormulaUnits& units,
                                       const std::vector<std::vector<double>>& values);

}  // namespace pendular
