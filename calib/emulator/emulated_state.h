#pragma once

#include <array>
#include <optional>
#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/estimate.h"

namespace pendular {

/// Emulated value of one observable at one state, with derivatives and standard errors.
struct EmulatedObservable {
    dem::Observable which;
    Estimate value;  ///< in the unit of the observable
    /// Derivatives with respect to the friction coefficient, ln I, 1/P* and V0/a^3, in the order of
    /// `Input`. Wet states have all four, dry states only the first two.
    std::vector<Estimate> slopes;
};

/// Returns the emulated values of the observables `which` at a state, in the order of `which`, for
/// grains with the stiffness number `stiffness_number` [1]. If the emulator cannot predict changes
/// with stiffness (`Emulator::knows_stiffness`), only solid fraction and overlap are converted to
/// this number. The standard errors include the error of the conversion. The derivatives leave out
/// the changes by effects on grains.
/// @throws std::invalid_argument if an observable describes liquid bridges but the state is dry, if
///         no training run has a value of an observable, or if the emulator cannot predict an
///         effect of the state (`Emulator::knows`)
std::vector<EmulatedObservable> emulated_at(const Emulator& emulator, const FlowState& state,
                                            double stiffness_number,
                                            const std::vector<dem::Observable>& which);

/// Returns the emulated observables that are defined at a state, in the order of
/// `emulated::observables`: all for wet grains, those that do not describe bridges for dry grains.
std::vector<dem::Observable> observables_of(const FlowState& state);

}  // namespace pendular
