#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "calib/emulator/effect_response.h"
#include "calib/emulator/plain_emulator.h"
#include "calib/emulator/query.h"
#include "sim/dem/run.h"

namespace pendular {

/// Emulator of all states between the training runs: a `PlainEmulator` and, for each effect on
/// grains, its response, trained on the runs that have this effect alone (EffectResponse). Changes
/// by several effects add up; derivatives are those without effects. It is a value: any number of
/// threads may ask it at once.
class Emulator {
  public:
    /// Trains on runs, as `PlainEmulator` does.
    Emulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
             double structure_stiffness = emulated::reference_stiffness)
        : plain_(runs, std::move(hyperparameters), structure_stiffness) {}

    /// Returns the emulator with further training runs and unchanged hyperparameters.
    Emulator with(const std::vector<dem::RunResult>& more) const;

    /// Hyperparameters in use, those fitted so far included.
    EmulatorHyperparameters hyperparameters() const { return plain_.hyperparameters(); }

    /// An entry for each query.
    /// @throws std::invalid_argument for an observable of bridges where no run was wet, or of a dry
    ///         state, and for an effect that no run has alone
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Covariance of the errors of `mean`, a row and a column for each query.
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// Coordinates in which a state lies beyond all runs, as in "friction 0.9 is above 0.6"; empty
    /// where it does not. Slower flow than any run is extrapolated, with its error, and no matter
    /// of this.
    std::string beyond(const FlowState& state) const;

    /// Training runs.
    const std::vector<dem::RunResult>& runs() const { return plain_.runs(); }

    /// Covariance of a run's stress ratio and solid fraction about those of a much longer run [1].
    Eigen::Matrix2d noise(const dem::RunResult& run) const { return plain_.noise(run); }
    double noise_variance(const dem::RunResult& run, dem::Observable which) const {
        return plain_.noise_variance(run, which);
    }

  private:
    const EffectResponse& response_to(const std::string& effect, dem::Observable which) const;
    std::unique_ptr<const EffectResponse> learned(const std::string& effect,
                                                  dem::Observable which) const;
    struct Affected;
    std::vector<Affected> affected(const std::vector<Query>& queries) const;

    /// Responses, each trained when it is first needed, once for all threads.
    struct Responses {
        struct Response {
            std::once_flag once;
            std::unique_ptr<const EffectResponse> learned;
        };
        std::mutex mutex;  ///< of the map; its entries stay where they are
        std::map<std::pair<std::string, dem::Observable>, Response> all;
    };
    PlainEmulator plain_;
    std::unique_ptr<Responses> responses_ = std::make_unique<Responses>();
};

}  // namespace pendular
