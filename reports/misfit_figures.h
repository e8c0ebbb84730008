#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of the misfit between readings and a model:
/// - `qq`: ordered residuals, decorrelated and in standard errors [1], against the quantiles of a
///   normal distribution; left out for fewer than three readings.
/// - `chi2_ledger`: contributions to chi2 per measured value [1], beside the expected value 1: of
///   shear stress and solid fraction, of up to six files and of up to ten conditions, the largest
///   first.
std::vector<Figure> misfit_figures(const Comparison& comparison);

/// Returns figures of the residuals, (measured - predicted)/(standard error of the difference) [1]:
/// - `residuals`: of shear stress and solid fraction of each reading, in one panel for each
///   quantity that varies between the readings
/// - `residual_map`: mean residual of each condition, in standard errors of the mean [1], in the
///   plane of normal stress and inertial number, with one panel for each liquid content and
///   observable; left out if all readings have one inertial number
std::vector<Figure> residual_figures(const Comparison& comparison);

/// Returns the figures of `pendular compare`: dry readings, wet readings, predicted against
/// measured values (`parity`), residuals, contributions to chi2, and fitted parameters. The
/// predictions are those of the fitted model with all effects of the study.
std::vector<Figure> comparison_figures(const StudyModel& model, const Calibration& calibration,
                                       const Comparison& comparison);

}  // namespace pendular
