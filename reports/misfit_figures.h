#pragma once

#include <vector>

#include "analysis/ladder.h"
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

/// Says in the titles of figures that the fit is not to be used.
void mark_as_rejected(std::vector<Figure>& figures);

/// Returns two figures of the dry readings; none if the study has no dry readings.
/// - `calibration`: stress ratio and solid fraction against friction. The curve is the fitted model
///   without effects on the instrument. The band is the mean of the readings at the lowest inertial
///   number with its standard error, corrected for these effects. Curve and band cross at the
///   friction that these readings alone would give. Source: the calibration figure of Badetti et
///   al. (2018).
/// - `inertial_number`: measured and predicted values against the inertial number. If the
///   predictions differ between normal stresses, masses of beads or files, each has its own curve.
std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration);

/// Returns the figures of the wet readings at the lowest inertial number, within 20 %; none if the
/// study has no wet readings.
/// - `stress_ratio_wet`, against 1/P*: for each liquid content the readings, their predictions,
///   curves of the model, and straight cohesion lines (Mohr-Coulomb)
/// - `solid_fraction_wet`, against 1/P*: the same without cohesion lines
/// - `reduced_cohesion`, against the liquid content: from lines through the readings, from lines
///   through the model, and from the simulated structure (solid fraction and coordination number),
///   with and without capillary shear stress; left out if it would have none of these
///
/// P* and the reduced cohesion are normalised with the pull-off force F0 of the study's liquid,
/// even if the fit changes the surface tension; the titles then state the fitted F0 [µN].
/// Source: Badetti et al. (2018), Fig. 7, Fig. 9 and Fig. 8.
/// @param cohesion options with which the cohesion lines of the calibration were fitted
std::vector<Figure> wet_figures(const StudyModel& model, const Calibration& calibration,
                                const CohesionOptions& cohesion = {});

/// Returns figures of the parameters that the readings determine:
/// - `profile`: profile likelihood of up to eight parameters, beside the parabola that follows from
///   the standard error
/// - `error_budget`: parts of the standard error of the first parameter, in a study that states
///   uncertainties of its instrument
/// - `corner`: confidence region of each pair of up to five parameters; left out for fewer than two
std::vector<Figure> parameter_figures(const StudyModel& model, const Calibration& calibration);

/// Returns a figure of the last ten ladder steps. The upper panel shows chi2/dof [1] (about 1 for a
/// correct model). The lower panel shows the relative RMS errors of shear stress and solid fraction
/// [%], for the readings and for conditions left out of the fit. A vertical line marks a step with
/// which the sequence starts anew.
Figure ladder_figure(const Ladder& ladder);

}  // namespace pendular
