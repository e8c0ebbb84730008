#pragma once

#include <vector>

#include "calib/emulator/query.h"
#include "calib/fit/calibration.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Reduced cohesion c* = a^2 c/F0 [1] predicted from the simulated structure of wet grains, for
/// readings of one liquid content and one inertial number.
struct StructuralCohesion {
    double liquid_content = 0;   ///< [1], mean of the group (`wet_groups`)
    double inertial_number = 0;  ///< [1], mean of the group
    /// c* by Rumpf's formula, mu*_0 Phi_S Z*/pi, with the stress ratio mu*_0 of dry grains.
    /// Source: Badetti et al. (2018), Eq. (24).
    Estimate rumpf;
    /// c* with the shear stress s12cap of the capillary forces: `rumpf` - a^2 s12cap/F0.
    /// Source: Badetti et al. (2018), Eq. (25).
    Estimate generalised;
};

/// Returns c* for each group of wet readings of steady shear (`wet_groups`), predicted at the
/// calibrated parameters: the mean over the readings of the group whose reduced pressure is at
/// least `options.lowest_reduced_pressure`. A group without such a reading is left out.
///
/// The prediction includes the study's effects on grains and liquid, but no effects on the
/// instrument. Cohesions are divided by F0/a^2 of the study's liquid. The standard errors leave out
/// the errors of the coordination number and of the capillary shear stress, which are unknown.
/// Source: Badetti et al. (2018), Fig. 8.
std::vector<StructuralCohesion> structural_cohesions(const StudyModel& model,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options = {});

}  // namespace pendular
