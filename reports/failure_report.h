#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// Text of a probability: "= 0.02" or "< 0.001"; `equals` replaces "= ".
std::string p_text(double p, const char* equals = "= ");

/// Checks with p < 0.05, the smallest p first.
std::vector<const Check*> significant_checks(const Checks& checks);

/// Lines that say where a model fails: first the overall check, then each significant one.
std::vector<std::string> checks_table(const Checks& checks);

/// Sentence that names the measurements with the least p; empty for an empty list.
std::string deviating_line(std::vector<std::pair<std::string, double>> measurements);

/// Checks that fail, one line each, then the conditions and files that deviate most.
std::vector<std::string> failure_table(const WhereItFails& where);

}  // namespace pendular
