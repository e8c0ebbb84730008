#pragma once

#include <map>
#include <optional>

#include "calib/emulator/gaussian_process.h"
#include "sim/dem/run.h"

namespace pendular {

/// Variable by which an emulated observable is differentiated: friction, ln I, 1/P* or V0/a^3.
enum class Input { friction, log_inertial_number, inverse_pressure, bridge_volume };

/// Query to the emulator: for the value of an observable at a flow state, or for a derivative of
/// the observable there.
struct Query {
    FlowState state;
    dem::Observable which = dem::Observable::stress_ratio;
    std::optional<Input> by = {};  ///< variable of the derivative; empty: the value
};

/// Hyperparameters of the emulator's Gaussian processes, by observable; observables may be missing.
using EmulatorHyperparameters = std::map<dem::Observable, Hyperparameters>;

}  // namespace pendular
