#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// Text of a probability p [1], to follow "p ": "= 0.02", or "< 0.001" below 0.001. `equals`: text
/// in place of "= ".
std::string p_text(double p, const char* equals = "= ");

/// Returns the checks of a model's residuals that are significant each by itself, with p < 0.05,
/// the smallest p first. The pointers point into `checks`.
std::vector<const Check*> significant_checks(const Checks& checks);

/// Lines of text on where a model fails: first the p value of all checks together, then one line
/// for each check with p < 0.05 (one line for all checks of correlation between conditions).
std::vector<std::string> checks_table(const Checks& checks);

/// Sentence that names the up to three measurements with the smallest p and the number of the
/// others; empty for an empty list.
/// @param measurements names of measurements with their p: the probability of so large a deviation
///        from the model by chance
std::string deviating_line(std::vector<std::pair<std::string, double>> measurements);

/// Lines of text on where a model fails: the lines of `checks_table`, then a line on the conditions
/// and files whose readings deviate most from the model, if there are any.
std::vector<std::string> failure_table(const WhereItFails& where);

}  // namespace pendular
