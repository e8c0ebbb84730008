#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// The figures of wet readings, none where there are none:
/// - `stress_ratio_wet` and `solid_fraction_wet` against 1/P*, for each liquid content the
/// readings,
///   what the fitted model says of them, and the model between them; in the former also the
///   straight lines of the Mohr-Coulomb cohesion, drawn on below the P* they are fitted for. Where
///   the model depends on the mass of beads or on the file there is a curve for each;
/// - `reduced_cohesion` against liquid content: measured, of the model, and explained by the
///   simulated structure, with and without capillary shear stress; where there is a line to take it
///   from. The cohesion explained by structure is scaled by the change that instrument effects
///   make to the model's cohesion, so that all values are as the instrument shows them.
/// F0 is that of the study's liquid on all axes, as in tables, so that measured points stay where
/// they are when another liquid is fitted; the title says what F0 was fitted.
/// The lines are the calibration's, made with these options. All show the wet readings of the
/// lowest inertial number, within 20 %. Colours and symbols are those of symbol_code.h. Source:
/// Badetti et al. (2018), fig:cexpnum, fig:phiexpnum and fig:cphilphis.
std::vector<Figure> wet_figures(const StudyModel& model, const Calibration& calibration,
                                const CohesionOptions& cohesion = {});

}  // namespace pendular
