#pragma once

#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/structure_response.h"

namespace pendular {

/// Sum of some observables at a wet state with its derivatives, emulated.
StructureResponse respond(const Emulator& emulator, const std::vector<dem::Observable>& sum,
                          const FlowState& state);

/// Z, contacts and distant bridges together [1].
StructureResponse coordination(const Emulator& emulator, const FlowState& state);

/// V0/a^3 that gives a liquid content at this friction, inertial number and reduced pressure: the
/// solution of Phi_L/Phi_S = 3 Z(V0) V0/(pi a^3).
/// Source: Badetti et al. (2018), eq:lcont.
double bridge_volume_of(const Emulator& emulator, double liquid_content, FlowState state);

}  // namespace pendular
