#pragma once

#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/fit/calibration.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Reduced cohesion [1] that the simulated structure of wet beads explains, for readings of one
/// liquid content and one inertial number.
struct StructuralCohesion {
    double liquid_content = 0;   ///< Phi_L/Phi_S [1]
    double inertial_number = 0;  ///< I [1]
    Estimate rumpf;              ///< mu*_0 Phi_S Z*/pi, eq:cohesion3
    Estimate generalised;        ///< `rumpf` less a^2 s12cap/F0, eq:cohgen
};

/// Averages of both over the wet readings of each of `wet_groups` whose P* is at or above the
/// limit, at the calibrated parameters: grains and liquid are as the study's effects make them, the
/// dry stress ratio mu*_0 is that of wet grains without bridges at the same inertial number. The
/// unit is F0/a^2 with F0 of the study's liquid, as in `cohesion_lines`, whatever liquid was
/// fitted. Effects on the instrument are left out. Groups without such readings are left out too.
/// The errors are those of the fitted parameters, the dry stress ratio and the solid fraction;
/// those of Z* and s12cap are not known and left out. Source: Badetti et al. (2018), fig:cphilphis.
std::vector<StructuralCohesion> structural_cohesions(const StudyModel& model,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options = {});

}  // namespace pendular
