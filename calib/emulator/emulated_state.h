#pragma once

#include <array>
#include <optional>
#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/estimate.h"

namespace pendular {

/// Emulated value of one observable at one state of steady shear, with its derivatives and their
/// standard errors.
struct EmulatedObservable {
    dem::Observable which;
    /// Emulated value with its standard error, in the unit of the observable.
    Estimate value;
    /// Derivatives of the value with respect to friction, ln I, 1/P* and V0/a^3, in the order of
    /// `Input`, with their standard errors (I: inertial number, P*: reduced pressure, V0: bridge
    /// volume, a: grain diameter). Wet states have all four, dry states only the first two.
    std::vector<Estimate> slopes;
};

/// Returns the emulated values of the observables `which` at a state of steady shear, in the order
/// of `which`, as runs with grains of the stiffness number `stiffness_number` [1] would measure
/// them. The standard errors include the error of the conversion to this stiffness number. The
/// derivatives leave out the part that comes from effects on grains.
/// @throws std::invalid_argument if an observable describes liquid bridges but the state is dry, if
///         no training run has a value of an observable, or if `state` has an effect that no run
///         has as its only effect
std::vector<EmulatedObservable> emulated_at(const Emulator& emulator, const FlowState& state,
                                            double stiffness_number,
                                            const std::vector<dem::Observable>& which);

/// Returns the emulated observables that are defined at a state of steady shear: all for wet
/// grains, all except those of liquid bridges for dry grains. The order is that of
/// `emulated::observables`.
std::vector<dem::Observable> observables_of(const FlowState& state);

}  // namespace pendular
