#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of the wet readings at the lowest inertial number, within 20 %; none where
/// there are no wet readings. P* is the reduced pressure.
/// - `stress_ratio_wet` and `solid_fraction_wet`, against 1/P*: for each liquid content, the
///   readings, the model's prediction of each reading, and curves of the model. Where the
///   predictions differ between masses of beads or files, there is a curve for each of them.
///   `stress_ratio_wet` also shows the straight cohesion lines (Mohr-Coulomb), extended to P* below
///   the range of the fit.
/// - `reduced_cohesion`, against liquid content: from measured lines, from lines of the model, and
///   as explained by the simulated structure (solid fraction and coordination number), with and
///   without capillary shear stress. The change of cohesion by instrument effects in the model is
///   added to the structural values, so that all values are as the instrument shows them. Left out
///   where there is neither a line nor a structural value.
/// All axes use the pull-off force F0 of the study's liquid, so that measured points stay in place
/// when another liquid is fitted; the title states a fitted F0 [µN].
/// Source: Badetti et al. (2018), fig:cexpnum, fig:phiexpnum and fig:cphilphis.
/// @param cohesion the options with which the calibration's cohesion lines were fitted
std::vector<Figure> wet_figures(const StudyModel& model, const Calibration& calibration,
                                const CohesionOptions& cohesion = {});

}  // namespace pendular
