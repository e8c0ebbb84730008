#pragma once

#include <vector>

#include "calib/emulator/estimate.h"
#include "calib/fit/calibration.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Reduced cohesion c* = a^2 c/F0 [1] predicted from the simulated structure of wet grains, for
/// readings of one liquid content and one inertial number. Here c is the cohesion, a the grain
/// diameter and F0 the pull-off force of a liquid bridge.
struct StructuralCohesion {
    /// Liquid content (liquid volume divided by grain volume) [1], mean over the group of wet
    /// readings (`wet_groups`).
    double liquid_content = 0;
    /// Inertial number I [1], mean over the group of wet readings (`wet_groups`).
    double inertial_number = 0;
    /// Reduced cohesion c* [1] by Rumpf's formula, mu*_0 Phi_S Z*/pi, with the stress ratio mu*_0
    /// of dry grains, the solid fraction Phi_S and the effective coordination number Z*.
    /// Source: Badetti et al. (2018), Eq. (24).
    Estimate rumpf;
    /// Reduced cohesion c* [1] that includes the shear stress s12cap of the capillary forces:
    /// `rumpf` - a^2 s12cap/F0, with the grain diameter a and the pull-off force F0 of a liquid
    /// bridge.
    /// Source: Badetti et al. (2018), Eq. (25).
    Estimate generalised;
};

/// Returns, for each group of wet readings of steady shear with about equal liquid contents and
/// inertial numbers (`wet_groups`), the reduced cohesion predicted from the simulated structure of
/// the wet grains at the calibrated parameters. The reduced cohesion is the mean over the readings
/// of the group whose reduced pressure is at least `options.lowest_reduced_pressure`. A group
/// without such a reading is left out.
///
/// The prediction includes the study's effects on grains and liquid, but no effects on the
/// instrument. Cohesions are divided by F0/a^2 with the pull-off force F0 of the study's liquid and
/// the grain diameter a. The standard errors leave out the errors of the coordination number and of
/// the capillary shear stress, which are unknown.
/// Source: Badetti et al. (2018), Fig. 8.
std::vector<StructuralCohesion> structural_cohesions(const StudyModel& model,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options = {});

}  // namespace pendular
