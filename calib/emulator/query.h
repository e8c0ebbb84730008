#pragma once

#include <map>
#include <optional>

#include "calib/emulator/gaussian_process.h"
#include "sim/dem/run.h"

namespace pendular {

/// Variable by which an emulated observable is differentiated.
enum class Input { friction, log_inertial_number, inverse_pressure, bridge_volume };

/// Query to the emulator: an observable at a state, or a derivative of the observable there.
struct Query {
    FlowState state;
    dem::Observable which = dem::Observable::stress_ratio;
    std::optional<Input> by = {};  ///< variable of the derivative; empty: the value
};

/// Hyperparameters of the emulator, for each observable.
using EmulatorHyperparameters = std::map<dem::Observable, Hyperparameters>;

}  // namespace pendular
