#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/catalogue/formula.h"

namespace pendular {

/// Formula of a quantity, with SI units: of the quantity that it gives, and of its variables in
/// their order; the unit of the last variable, the parameter, is the one to check.
struct FormulaUnits {
    std::string target;
    std::vector<std::string> variables;
};

/// Checks the dimension of a formula: in other units of mass, length and time, its value must
/// change as the quantity that it gives does. Angles count as numbers.
/// @param text text of the formula; where it contains numbers that may have a dimension, which are
///        limits in comparisons and all but 0, 1 and powers, nothing is checked
/// @param values values of the variables in SI units, for each of some typical states
/// @returns the SI unit that the last variable should have, empty text where no unit makes the
///          dimension right; no value where it is right, or where nothing was checked
std::optional<std::string> better_unit(const CompiledFormula& formula, const std::string& text,
                                       const FormulaUnits& units,
                                       const std::vector<std::vector<double>>& values);

}  // namespace pendular
