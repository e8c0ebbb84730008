#pragma once

#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "data/reading.h"

namespace pendular {

/// Text tables, one string a line, units in the header.

/// Table of the readings, one line each.
std::vector<std::string> readings_table(const Measurements& measurements);

/// Table of the rows that were left out, one line for each range, with the reason.
std::vector<std::string> excluded_table(const Measurements& measurements);

/// Table of the scatter between steps and between fillings [% of the value], from replicates; empty
/// without replicates.
std::vector<std::string> scatter_table(const Measurements& measurements);

/// Measured and predicted values of each reading.
std::vector<std::string> predictions_table(const Comparison& comparison, bool worst_first = false);

/// Misfit by observable, by condition and by covariate; the parts of chi2 add up to the total.
std::vector<std::string> misfit_table(const Comparison& comparison);

/// Cohesion lines, measured beside simulated; empty where there are none.
std::vector<std::string> cohesion_table(const std::vector<CohesionLine>& lines);

}  // namespace pendular
