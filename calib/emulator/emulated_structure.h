#pragma once

#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/structure_response.h"

namespace pendular {

/// Emulated sum of the observables `sum` at a wet flow state, with its derivatives by friction and
/// by ln(V0/a^3), V0 the bridge volume.
StructureResponse respond(const Emulator& emulator, const std::vector<dem::Observable>& sum,
                          const FlowState& state);

/// Emulated coordination number Z at a wet flow state [1], contacts and distant bridges together,
/// with its derivatives by friction and by ln(V0/a^3), V0 the bridge volume.
StructureResponse coordination(const Emulator& emulator, const FlowState& state);

/// Emulated bridge volume V0/a^3 [1] that gives the liquid content Phi_L/Phi_S [1] at the friction,
/// inertial number and reduced pressure of the wet state `state`: the solution of Phi_L/Phi_S = 3
/// Z(V0) V0/(pi a^3), with the emulated coordination number Z.
/// Source: Badetti et al. (2018), eq:lcont.
double bridge_volume_of(const Emulator& emulator, double liquid_content, FlowState state);

}  // namespace pendular
