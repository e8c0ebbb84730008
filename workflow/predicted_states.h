#pragma once

#include <Eigen/Core>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "workflow/state_prediction.h"

namespace pendular {

/// Observables that an emulator predicts at many states of steady shear: rows are states, columns
/// `observables`. An observable that a state does not have, such as the force of bridges between
/// dry grains, is NaN, and so is every number of a state that cannot be predicted.
struct PredictedStates {
    std::vector<dem::Observable> observables;
    Eigen::MatrixXd value, standard_error;  ///< in the unit of the observable
    /// Derivatives of the values with respect to one `Input` each, in its order: friction
    /// coefficient, ln I, 1/P* and V0/a^3. Empty if they were not requested.
    std::vector<Eigen::MatrixXd> slopes;
    Eigen::VectorXd bridge_volume;  ///< V0/a^3 [1]; NaN: dry
    /// Why each state cannot be predicted, such as "friction 0.9 is above 0.6"; empty: it can.
    std::vector<std::string> why_not;
};

/// Settings of `predict_states`.
struct StatesRequest {
    bool slopes = false;      ///< whether to compute derivatives, which takes three times as long
    std::size_t threads = 1;  ///< largest number; no result depends on it
    std::stop_token stop = {};
    /// Called by the calling thread with the number of finished states; may be empty.
    std::function<void(std::size_t)> report = {};
};

/// Predicts all observables at many states, as `StatePredictor::at` does at one. States with a
/// number outside of its range, and those that the earlier runs do not support, are left out, each
/// with its reason.
/// @throws InputError if the amount of liquid of a state is not given in exactly one way
/// @throws dem::Interrupted if a stop is requested
PredictedStates predict_states(const StatePredictor& predictor,
                               const std::vector<RequestedState>& requested,
                               const StatesRequest& request = {});

}  // namespace pendular
