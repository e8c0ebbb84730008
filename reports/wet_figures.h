#pragma once

#include <vector>

#include "calib/calibration.h"
#include "reports/figure.h"

namespace pendular {

/// The figures of wet readings, none where there are none:
/// - `stress_ratio_wet` and `solid_fraction_wet` against 1/P*, for each liquid content the
/// readings,
///   what the model says of them, and the model between them; in the former also the straight
///   lines of the Mohr-Coulomb cohesion, drawn on below the P* they are fitted for;
/// - `reduced_cohesion` against liquid content: measured, simulated, and explained by the simulated
///   structure, with and without capillary shear stress; where there is a line to take it from.
/// The lines are the calibration's, made with these options. All show the wet readings of the
/// lowest inertial number, within 20 %. Colours and symbols are those of symbol_code.h. Source:
/// Badetti et al. (2018), fig:cexpnum, fig:phiexpnum and fig:cphilphis.
std::vector<Figure> wet_figures(const StudyModel& model, const Calibration& calibration,
                                const CohesionOptions& cohesion = {});

}  // namespace pendular
