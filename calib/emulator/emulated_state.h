#pragma once

#include <array>
#include <optional>
#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/estimate.h"

namespace pendular {

/// Emulated value of one observable at one state, with its error, as a run of the given stiffness
/// number would measure it.
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

/// Observables that are defined at this state: those of bridges only where the grains are wet.
std::vector<dem::Observable> observables_of(const FlowState& state);

}  // namespace pendular
