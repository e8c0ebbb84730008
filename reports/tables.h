#pragma once

#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "data/reading.h"

namespace pendular {

// Text tables, one string per line, with the units in the header.

/// Table of the imported readings, one line per reading below a heading: normal stress [Pa],
/// inertial number [1], liquid content [1], shear stress [Pa] and solid fraction [1], the last two
/// with standard errors.
std::vector<std::string> readings_table(const Measurements& measurements);

/// Table of the rows of the measured files that import left out, one line for each range of rows,
/// with the reason.
std::vector<std::string> excluded_table(const Measurements& measurements);

/// Text that counts the ranges of rows that import left out, by kind: "44 transients, 6 readings
/// set aside"; empty where no rows were left out.
std::string excluded_text(const Measurements& measurements);

/// Whether import left out rows other than the transients of steps.
bool beyond_transients(const Measurements& measurements);

/// Table of the scatter of shear stress and solid fraction between repeated readings [% of the
/// value]: between steps of a recording, and between fillings of the cell. Empty where the scatter
/// is neither estimated nor stated.
std::vector<std::string> scatter_table(const Measurements& measurements);

/// Table of measured and predicted shear stresses [Pa] and solid fractions [1], one line per
/// reading, then one line per direct measurement of a parameter.
/// @param worst_first true: readings with the largest chi2 come first; false: order of the readings
std::vector<std::string> predictions_table(const Comparison& comparison, bool worst_first = false);

/// Text of a number of degrees of freedom: "46 degrees of freedom", "1 degree of freedom".
std::string freedom_text(int degrees_of_freedom);
/// Text on a misfit for use in a sentence: "chi2 = 45.72 for 46 degrees of freedom (p = 0.51)".
/// Where the p value includes an allowance for errors that are estimated from few repetitions, the
/// text says so.
std::string misfit_text(const Misfit& misfit);

/// Table of the contributions to chi2 [1]: of each quantity (shear stress, solid fraction), of each
/// condition and, where there are several files, of each file. The contributions of all quantities
/// add up to chi2 of all readings, as do those of all conditions and of all files.
std::vector<std::string> misfit_table(const Comparison& comparison);

/// Table of cohesion lines, straight lines of stress ratio against the inverse reduced pressure,
/// stress ratio = intercept + c*/P* with the reduced cohesion c*. The measured and the simulated
/// line of a liquid content and inertial number are one below the other. Empty where there are no
/// lines.
std::vector<std::string> cohesion_table(const std::vector<CohesionLine>& lines);

}  // namespace pendular
