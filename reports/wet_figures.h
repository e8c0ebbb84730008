#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

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

}  // namespace pendular
