#pragma once

#include <array>
#include <optional>
#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/estimate.h"

namespace pendular {

/// What the emulator says of one observable at one state, as a run of a stiffness number would have
/// measured it.
struct EmulatedObservable {
    dem::Observable which;
    Estimate value;
    /// Derivatives by friction, ln I, 1/P* and V0/a^3, in the order of `Input`; wet states have
    /// all, dry ones the first two.
    std::vector<Estimate> slopes;
};

/// The observables at a state that runs measure there, in the order of `emulated::observables`; all
/// of them, or some. Solid fraction and overlap are those at a stiffness number: the first with the
/// error of the correction from the reference one, the other inversely proportional to it.
/// @throws std::invalid_argument for an observable of bridges at a dry state
std::vector<EmulatedObservable> emulated_at(const Emulator& emulator, const FlowState& state,
                                            double stiffness_number,
                                            const std::vector<dem::Observable>& which);

/// Those that beads at this state have.
std::vector<dem::Observable> observables_of(const FlowState& state);

}  // namespace pendular
