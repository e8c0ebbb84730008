#pragma once

#include <array>
#include <optional>
#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/estimate.h"

namespace pendular {

/// Emulated value of one observable at one flow state, with its standard error, as a run of a given
/// stiffness number would measure the observable.
struct EmulatedObservable {
    dem::Observable which;
    /// Emulated value with its standard error, in the unit of the observable.
    Estimate value;
    /// Derivatives of the value by friction, ln I, 1/P* and V0/a^3, in the order of `Input`, with
    /// their standard errors. Wet states have all four, dry states only the first two.
    std::vector<Estimate> slopes;
};

/// Emulated values of the observables `which` for grains of the stiffness number `stiffness_number`
/// [1] at a flow state, in the order of `which`. The errors include those of the change with
/// stiffness. Derivatives of observables other than solid fraction and overlap are those at the
/// stiffness number of the training runs.
/// @throws std::invalid_argument for an observable of bridges at a dry state, an observable of
///         which no training run has a value, and an effect of `state` that no run has alone
std::vector<EmulatedObservable> emulated_at(const Emulator& emulator, const FlowState& state,
                                            double stiffness_number,
                                            const std::vector<dem::Observable>& which);

/// Emulated observables that are defined at a flow state: all where the grains are wet, all but
/// those of liquid bridges where they are dry. The order is that of `emulated::observables`.
std::vector<dem::Observable> observables_of(const FlowState& state);

}  // namespace pendular
