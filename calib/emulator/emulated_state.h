#pragma once

#include <array>
#include <optional>
#include <vector>

#include "calib/emulator/emulator.h"
#include "calib/emulator/query.h"

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

/// Returns the same for several states, a list for each. They take less time together than one by
/// one, since products of matrices take the place of products with vectors; the results agree to
/// rounding errors.
/// @param slopes whether to compute derivatives; without them, `EmulatedObservable::slopes` is
/// empty
/// @param which observables to predict, where a state has them: those of bridges are left out of
/// dry
///        states
std::vector<std::vector<EmulatedObservable>> emulated_at(const Emulator& emulator,
                                                         std::vector<FlowState> states,
                                                         double stiffness_number,
                                                         const std::vector<dem::Observable>& which,
                                                         bool slopes);

/// Returns the emulated observables that are defined at a state, in the order of
/// `emulated::observables`: all for wet grains, those that do not describe bridges for dry grains.
std::vector<dem::Observable> observables_of(const FlowState& state);

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
