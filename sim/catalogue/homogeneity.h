#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/catalogue/formula.h"

namespace pendular {

/// SI units in a formula: of the result and of each variable. The last variable is the parameter of
/// an effect, whose unit is to be checked.
struct FormulaUnits {
    std::string target;
    std::vector<std::string> variables;
};

/// Returns the SI unit of the last variable that makes a formula dimensionally homogeneous, or an
/// empty text if no unit does; empty optional if the stated unit is right or cannot be checked.
/// Angles count as dimensionless. A formula with comparisons, or with numbers other than 0, 1 and
/// exponents, cannot be checked, since such numbers may have a dimension.
/// @param values of the variables in SI units, one list for each of several typical states
std::optional<std::string> better_unit(const CompiledFormula& formula, const std::string& text,
                                       const FormulaUnits& units,
                                       const std::vector<std::vector<double>>& values);

}  // namespace pendular
