#pragma once

#include <map>
#include <optional>

#include "calib/emulator/gaussian_process.h"
#include "sim/dem/run.h"

namespace pendular {

/// Variable by which an emulated observable is differentiated: the friction coefficient, ln I (I:
/// inertial number), 1/P* (P*: reduced pressure) or V0/a^3 (V0: bridge volume, a: grain diameter).
enum class Input { friction, log_inertial_number, inverse_pressure, bridge_volume };

/// Request to the emulator: for the value of an observable at a state of steady shear, or for its
/// derivative with respect to one variable.
struct Query {
    FlowState state;
    dem::Observable which = dem::Observable::stress_ratio;
    /// Variable with respect to which the observable is differentiated; empty: the value of the
    /// observable is requested.
    std::optional<Input> by = {};
};

/// Hyperparameters of the emulator's Gaussian processes, by observable; observables may be missing.
using EmulatorHyperparameters = std::map<dem::Observable, Hyperparameters>;

}  // namespace pendular
