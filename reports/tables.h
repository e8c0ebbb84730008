#pragma once

#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "data/reading.h"

namespace pendular {

// Text tables, one string per line, with the units in the header.

/// Table of the readings, one line per reading.
std::vector<std::string> readings_table(const Measurements& measurements);

/// Table of the rows that were left out, one line for each range, with the reason.
std::vector<std::string> excluded_table(const Measurements& measurements);

/// Table of the scatter of replicates [% of the value]: between steps, and between fillings of the
/// cell. Empty without replicates.
std::vector<std::string> scatter_table(const Measurements& measurements);

/// Table of measured and predicted values, one line per reading, then the direct measurements. In
/// the order of the readings or, if `worst_first`, with the largest chi2 first.
std::vector<std::string> predictions_table(const Comparison& comparison, bool worst_first = false);

/// Table of chi2 by observable, by condition and, where there are several, by file. Each division
/// adds up to the chi2 of all readings.
std::vector<std::string> misfit_table(const Comparison& comparison);

/// Table of the Mohr-Coulomb cohesion lines, with the measured and the simulated line of a
/// condition one below the other; empty without lines.
std::vector<std::string> cohesion_table(const std::vector<CohesionLine>& lines);

}  // namespace pendular
