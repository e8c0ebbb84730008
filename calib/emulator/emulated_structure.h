#pragma once

#include <vector>

#include "calib/emulator/emulator.h"

namespace pendular {

/// Quantity of the network of contacts and bridges, such as the coordination number, with
/// derivatives, all in the unit of the quantity.
struct StructureResponse {
    double value = 0;
    double by_friction = 0;
    double by_log_volume = 0;  ///< with respect to ln(V0/a^3)
};

/// Returns the sum of the emulated observables `sum` at a wet state, with its derivatives.
StructureResponse respond(const Emulator& emulator, const std::vector<dem::Observable>& sum,
                          const FlowState& state);

/// Returns the emulated coordination number Z = Z_c + Z_d at a wet state [1], with its derivatives.
StructureResponse coordination(const Emulator& emulator, const FlowState& state);

/// Returns the bridge volume V0/a^3 [1] at which the grains in the wet state `state`, whose own
/// bridge volume is ignored, have a given liquid content [1]: solves
///     liquid_content = 3 Z(V0) V0/(pi a^3)
/// with the emulated coordination number Z, but at least 1.
/// Source: Badetti et al. (2018), Eq. (6).
double bridge_volume_of(const Emulator& emulator, double liquid_content, FlowState state);

}  // namespace pendular
