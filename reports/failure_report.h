#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// Text of a probability: "= 0.02", or "< 0.001" below 0.001; `equals` replaces "= ".
std::string p_text(double p, const char* equals = "= ");

/// Checks of a model that are significant alone, p < 0.05, the smallest p first.
std::vector<const Check*> significant_checks(const Checks& checks);

/// Lines on where a model fails: first the joint probability of all checks, then one line for each
/// check with p < 0.05.
std::vector<std::string> checks_table(const Checks& checks);

/// Sentence that names up to three measurements with the smallest p; empty for an empty list.
/// @param measurements names of measurements with their p: the probability of so large a deviation
///        from the model by chance
std::string deviating_line(std::vector<std::pair<std::string, double>> measurements);

/// Lines of `checks_table`, then a line on the conditions and files that deviate most from the
/// model.
std::vector<std::string> failure_table(const WhereItFails& where);

}  // namespace pendular
