#pragma once

#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/fit/calibration.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Reduced cohesion c* = a^2 c/F0 [1] predicted from the simulated structure of wet grains, for
/// readings of one liquid content and one inertial number.
struct StructuralCohesion {
    double liquid_content = 0;   ///< liquid content Phi_L/Phi_S [1], mean of the group
    double inertial_number = 0;  ///< inertial number I [1], mean of the group
    Estimate rumpf;              ///< c* by Rumpf's formula: mu*_0 Phi_S Z*/pi [1], eq:cohesion3
    Estimate generalised;        ///< c*: `rumpf` minus a^2 s12cap/F0 [1], eq:cohgen
};

/// Returns the reduced cohesion from the simulated structure of wet grains for each group of wet
/// readings (`wet_groups`) at the calibrated parameters: averages over the readings whose P* is at
/// or above the limit of `options`. Groups without such readings are left out. Grains and liquid
/// are as the study's effects change them; effects on the instrument are left out. The dry stress
/// ratio mu*_0 is that of the wet grains without bridges at the same inertial number. Cohesions are
/// reduced by F0/a^2 with F0 of the study's liquid, as in `cohesion_lines`, whatever liquid was
/// fitted. The standard errors include the errors of the fitted parameters, the dry stress ratio
/// and the solid fraction; the errors of the coordination number Z* and capillary shear stress
/// s12cap are unknown and left out.
/// Source: Badetti et al. (2018), fig:cphilphis.
std::vector<StructuralCohesion> structural_cohesions(const StudyModel& model,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options = {});

}  // namespace pendular
