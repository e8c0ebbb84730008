#pragma once

#include <vector>

#include "calib/calibration.h"
#include "calib/cohesion_lines.h"
#include "calib/simulation_model.h"

namespace pendular {

/// Reduced cohesion [1] that the simulated structure of wet beads explains, for readings of one
/// liquid content and one inertial number.
struct StructuralCohesion {
    double liquid_content = 0;   ///< Phi_L/Phi_S [1]
    double inertial_number = 0;  ///< I [1]
    Estimate rumpf;              ///< mu*_0 Phi_S Z*/pi, eq:cohesion3
    Estimate generalised;        ///< the same less a^2 s12cap/F0, eq:cohgen
};

/// Averages of both over the wet readings of each of `wet_groups` whose P* is at or above the
/// limit, at the calibrated friction, with the dry stress ratio mu*_0 of the same inertial number.
/// Groups without such readings are left out. The errors are those of the friction, the dry stress
/// ratio and the solid fraction; those of Z* and s12cap are not known and left out.
/// Source: Badetti et al. (2018), fig:cphilphis.
std::vector<StructuralCohesion> structural_cohesions(const SimulationModel& simulation,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options = {});

}  // namespace pendular
