#pragma once

#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/structure_response.h"

namespace pendular {

/// Returns the sum of the emulated values of several observables, such as the numbers of contacts
/// and of bridges per grain, at a state of steady shear of wet grains. The result contains the
/// derivatives of the sum with respect to the friction coefficient and to ln V0, where V0 is the
/// bridge volume.
/// @param sum observables to add
StructureResponse respond(const Emulator& emulator, const std::vector<dem::Observable>& sum,
                          const FlowState& state);

/// Returns the emulated coordination number Z = Z_c + Z_d at a wet state [1], with the derivatives
/// of Z with respect to the friction coefficient and to ln V0, where V0 is the bridge volume. Z_c
/// is the number of contacts per grain, and Z_d the number of bridges without contact per grain.
StructureResponse coordination(const Emulator& emulator, const FlowState& state);

/// Returns the bridge volume V0/a^3 [1] at which the grains in the wet state `state` have a given
/// liquid content. The bridge volume of `state` is ignored. The function solves
///     liquid_content = 3 Z(V0) V0/(pi a^3)
/// for V0, with the grain diameter a and the emulated coordination number Z. If Z is below 1, the
/// function uses 1 instead.
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// Source: Badetti et al. (2018), Eq. (6).
double bridge_volume_of(const Emulator& emulator, double liquid_content, FlowState state);

}  // namespace pendular
