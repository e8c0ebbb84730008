#pragma once

#include <map>
#include <optional>

#include "calib/emulator/gaussian_process.h"
#include "sim/dem/run.h"

namespace pendular {

/// Number with its standard error; both have the same unit.
struct Estimate {
    double value = 0;
    double standard_error = 0;
};

/// Variable of a derivative: friction coefficient, ln I, 1/P*, or V0/a^3.
enum class Input { friction, log_inertial_number, inverse_pressure, bridge_volume };

/// Request to the emulator for an observable at a state, or for its derivative.
struct Query {
    FlowState state;
    dem::Observable which = dem::Observable::stress_ratio;
    std::optional<Input> by = {};  ///< empty: the value
};

/// Hyperparameters of observables, not necessarily of all.
using EmulatorHyperparameters = std::map<dem::Observable, Hyperparameters>;

}  // namespace pendular
