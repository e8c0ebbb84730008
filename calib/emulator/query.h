#pragma once

#include <map>
#include <optional>

#include "calib/emulator/gaussian_process.h"
#include "sim/dem/run.h"

namespace pendular {

/// Variable with respect to which an emulated observable is differentiated: the friction
/// coefficient, ln I with the inertial number I, the inverse reduced pressure 1/P*, or the bridge
/// volume V0 divided by the cubed grain diameter a^3.
enum class Input { friction, log_inertial_number, inverse_pressure, bridge_volume };

/// Request to the emulator for the value of an observable at a state of steady shear, or for the
/// derivative of the observable with respect to one variable. The emulator interpolates
/// simulations.
struct Query {
    FlowState state;
    dem::Observable which = dem::Observable::stress_ratio;
    /// Variable with respect to which the observable is differentiated; empty if the value of the
    /// observable is requested.
    std::optional<Input> by = {};
};

/// Hyperparameters (amplitudes, correlation lengths and noise) of the emulator's Gaussian
/// processes, with the observable as the key. The map need not contain all observables.
using EmulatorHyperparameters = std::map<dem::Observable, Hyperparameters>;

}  // namespace pendular
