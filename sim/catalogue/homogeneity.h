#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/catalogue/formula.h"

namespace pendular {

/// SI units of the quantity that a formula gives (`target`) and of the formula's variables, in
/// their order. The last variable is the parameter, whose unit is to be checked.
struct FormulaUnits {
    std::string target;
    std::vector<std::string> variables;
};

/// Unit that the last variable of a formula should have in place of its present unit, so that the
/// formula gives its target in every system of units of mass, length and time. Angles count as
/// numbers.
/// @param text text of the formula; nothing is checked where it contains numbers that may have a
///         dimension: limits in comparisons, and all numbers except 0, 1 and powers
/// @param values values of the variables in SI units, one list for each of several typical states
/// @returns the SI unit that the last variable should have, or an empty text where no unit makes
///         the dimension right; no value where the present unit is right or nothing was checked
std::optional<std::string> better_unit(const CompiledFormula& formula, const std::string& text,
                                       const FormulaUnits& units,
                                       const std::vector<std::vector<double>>& values);

}  // namespace pendular
