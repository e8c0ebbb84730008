#pragma once

#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "data/reading.h"

namespace pendular {

// Text tables, one string per line, with the units in the header.

/// Returns a table of the imported readings, one line per reading below a heading. A reading is the
/// mean over the steady part of a step, or a point of failure. The columns are normal stress [Pa],
/// inertial number [1], liquid content [1], and, with standard errors, shear stress [Pa] and solid
/// fraction [1].
std::vector<std::string> readings_table(const Measurements& measurements);

/// Returns a table of the rows of the measured files that import left out, one line with the reason
/// for each range of rows.
std::vector<std::string> excluded_table(const Measurements& measurements);

/// Returns a text that counts the ranges of rows that import left out, by kind, such as "44
/// transients, 6 readings". The text is empty if no rows were left out.
std::string excluded_text(const Measurements& measurements);

/// Whether import left out rows of measured files other than transients (rows of a step outside of
/// its steady part).
bool beyond_transients(const Measurements& measurements);

/// Returns a table of the scatter of shear stress and solid fraction between repeated readings [%
/// of the value]: first the scatter that is independent in each step of a recording, second the
/// scatter that all steps of one filling of the cell share. Returns an empty list if the scatter is
/// neither estimated from the readings nor stated in study.toml.
std::vector<std::string> scatter_table(const Measurements& measurements);

/// Returns a table of measured and predicted shear stresses [Pa] and solid fractions [1], one line
/// per reading, then one line per direct measurement of an effect's parameter (without shearing
/// grains).
/// @param worst_first true: the reading with the largest contribution to chi2 comes first; false:
///        the lines are in the order of the readings
std::vector<std::string> predictions_table(const Comparison& comparison, bool worst_first = false);

/// Returns the text of a number of degrees of freedom: "46 degrees of freedom", "1 degree of
/// freedom".
std::string freedom_text(int degrees_of_freedom);
/// Returns a text on a misfit for use in a sentence: "chi2 = 45.7 for 46 degrees of freedom (p =
/// 0.51)". If the p value is much larger because the standard errors are estimated from few
/// repetitions, the text says so.
std::string misfit_text(const Misfit& misfit);

/// Returns a table of the contributions to chi2 [1] in three parts: shear stress and solid
/// fraction, each condition and, if there are several files, each file. The contributions in each
/// part add up to the chi2 of all readings.
std::vector<std::string> misfit_table(const Comparison& comparison);

/// Returns a table of cohesion lines. A cohesion line is a straight line of the stress ratio
/// against 1/P*, with the reduced pressure P* and the reduced cohesion c*:
///     stress ratio = intercept + c*/P*
/// For each liquid content and inertial number, the line through the readings and the line through
/// the model are one below the other. Returns an empty list if `lines` is empty.
std::vector<std::string> cohesion_table(const std::vector<CohesionLine>& lines);

}  // namespace pendular
