#pragma once

#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "data/reading.h"

namespace pendular {

/// Returns the name of a reading: "dry_1.csv step 3", or "table.csv:12" for a row of a table.
std::string place_of(const Reading& reading);

// Text tables, one string per line, with the units in the header.

/// Returns the imported readings: normal stress [Pa], inertial number [1], liquid content [1] and,
/// with standard errors, shear stress [Pa] and solid fraction [1].
std::vector<std::string> readings_table(const Measurements& measurements);

/// Returns the ranges of rows that import left out, each with the reason.
std::vector<std::string> excluded_table(const Measurements& measurements);

/// Returns the numbers of these ranges by kind, such as "44 transients, 6 readings"; empty for
/// none.
std::string excluded_text(const Measurements& measurements);

/// Whether import left out more than transients (rows of a step outside of its steady part).
bool beyond_transients(const Measurements& measurements);

/// Returns the relative scatter [%] of shear stress and solid fraction between repeated readings:
/// first that of each step of a recording, second that which all steps of one filling share. Empty
/// if it is neither estimated from the readings nor stated in study.toml.
std::vector<std::string> scatter_table(const Measurements& measurements);

/// Returns measured and predicted shear stresses [Pa] and solid fractions [1], one line per
/// reading, then one line per direct measurement of an effect.
/// @param worst_first whether the reading with the largest contribution to chi2 comes first
std::vector<std::string> predictions_table(const Comparison& comparison, bool worst_first = false);

/// Returns "46 degrees of freedom" or "1 degree of freedom".
std::string freedom_text(int degrees_of_freedom);
/// Returns "chi2 = 45.7 for 46 degrees of freedom (p = 0.51)" for use in a sentence, and says so if
/// p is much larger because the standard errors are estimated from few repetitions.
std::string misfit_text(const Misfit& misfit);

/// Returns the contributions to chi2 [1] of shear stress and solid fraction, of each condition and,
/// if there are several, of each file. Those of each part add up to the chi2 of all readings.
std::vector<std::string> misfit_table(const Comparison& comparison);

/// Returns a table of straight lines
///     stress ratio = intercept + c*/P*
/// for each liquid content and inertial number, the line through the readings above that through
/// the model. Empty if `lines` is empty.
std::vector<std::string> cohesion_table(const std::vector<CohesionLine>& lines);

}  // namespace pendular
