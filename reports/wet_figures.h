#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of the wet readings at the lowest inertial number, within 20 %. Returns no
/// figures where the study has no wet readings. P* is the reduced pressure.
/// - `stress_ratio_wet` and `solid_fraction_wet`, against 1/P*: for each liquid content, the
///   readings, the model's prediction of each reading, and curves of the model. Where the
///   predictions differ between masses of beads or files, the figure has one curve for each mass or
///   file. `stress_ratio_wet` also shows the straight cohesion lines (Mohr-Coulomb), extended to P*
///   below the range of the fit.
/// - `reduced_cohesion`, against liquid content: from measured lines, from lines of the model, and
///   as explained by the simulated structure (solid fraction and coordination number), with and
///   without capillary shear stress. The structural values include the change of cohesion that the
///   effects on the instrument cause in the model, so that all values are comparable with measured
///   ones. The figure is left out where it would have neither lines nor structural values. All axes
///   are normalised with the pull-off force F0 of the study's liquid, also if the fit changes the
///   surface tension, so that measured points stay in place; the title states a fitted F0 [µN].
/// Source: Badetti et al. (2018), fig:cexpnum, fig:phiexpnum and fig:cphilphis.
/// @param cohesion the options with which the calibration's cohesion lines were fitted
std::vector<Figure> wet_figures(const StudyModel& model, const Calibration& calibration,
                                const CohesionOptions& cohesion = {});

}  // namespace pendular
