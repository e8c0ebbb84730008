#pragma once

#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/fit/calibration.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Reduced cohesion c* = a^2 c/F0 [1] predicted from the simulated structure of wet grains, for
/// readings of one liquid content and one inertial number. c: cohesion; a: grain diameter; F0:
/// pull-off force of a liquid bridge.
struct StructuralCohesion {
    /// Liquid content (liquid volume divided by grain volume) [1], mean of the readings.
    double liquid_content = 0;
    double inertial_number = 0;  ///< inertial number I [1], mean of the readings
    /// Reduced cohesion c* by Rumpf's formula, mu*_0 Phi_S Z*/pi [1] (eq:cohesion3): stress ratio
    /// mu*_0 of dry grains, solid fraction Phi_S, effective coordination number Z*.
    Estimate rumpf;
    /// Reduced cohesion c* with the shear stress s12cap of the capillary forces: `rumpf` - a^2
    /// s12cap/F0 [1] (eq:cohgen). a: grain diameter; F0: pull-off force of a bridge.
    Estimate generalised;
};

/// Returns the reduced cohesion predicted from the simulated structure of wet grains at the
/// calibrated parameters, for each group of wet readings of steady shear (`wet_groups`): the mean
/// over the readings whose reduced pressure is at or above the limit of `options`. A group without
/// a reading at or above this limit is left out. Grains and liquid are as the study's effects
/// change them; effects on the instrument are left out. The stress ratio of dry grains is that of
/// the wet grains without bridges at the same inertial number. Cohesions are divided by F0/a^2 with
/// the pull-off force F0 of the study's liquid and the grain diameter a, as in `cohesion_lines`.
/// The standard errors include those of the fitted parameters, of the dry stress ratio and of the
/// solid fraction. They leave out the errors of the coordination number and of the capillary shear
/// stress, which are unknown.
/// Source: Badetti et al. (2018), fig:cphilphis.
std::vector<StructuralCohesion> structural_cohesions(const StudyModel& model,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options = {});

}  // namespace pendular
