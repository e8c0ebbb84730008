#pragma once

#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/structure_response.h"

namespace pendular {

/// Emulated sum of the observables `sum` at a wet state, with its derivatives by friction and
/// ln(V0/a^3).
StructureResponse respond(const Emulator& emulator, const std::vector<dem::Observable>& sum,
                          const FlowState& state);

/// Coordination number Z at a wet state [1], contacts and distant bridges together, with its
/// derivatives.
StructureResponse coordination(const Emulator& emulator, const FlowState& state);

/// Bridge volume V0/a^3 [1] that gives a liquid content [1] at the friction, inertial number and
/// reduced pressure of `state`: the solution of Phi_L/Phi_S = 3 Z(V0) V0/(pi a^3).
/// Source: Badetti et al. (2018), eq:lcont.
double bridge_volume_of(const Emulator& emulator, double liquid_content, FlowState state);

}  // namespace pendular
