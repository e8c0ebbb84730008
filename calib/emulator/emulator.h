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

/// Emulator: Gaussian processes trained on runs, which predict the observables of any state between
/// the training runs, with standard errors. A `PlainEmulator` predicts them for grains without
/// effects. For each effect on grains, an `EffectResponse` trained on the runs that have this
/// effect alone adds the change. Changes by several effects add up. Derivatives by the coordinates
/// of a state are those of the `PlainEmulator`: they omit the effects. The emulator never changes
/// after its construction: any number of threads may query it at once.
class Emulator {
  public:
    /// Trains on runs, with the arguments of `PlainEmulator`.
    /// @throws std::invalid_argument where no run can serve as a training run
    Emulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
             double structure_stiffness = emulated::reference_stiffness)
        : plain_(runs, std::move(hyperparameters), structure_stiffness) {}

    /// Returns the emulator with further training runs and unchanged hyperparameters.
    Emulator with(const std::vector<dem::RunResult>& more) const;

    /// Hyperparameters that were given at construction or fitted since.
    EmulatorHyperparameters hyperparameters() const { return plain_.hyperparameters(); }

    /// Predicted value or derivative for each query.
    /// @throws std::invalid_argument for an observable of which no training run has a value, for an
    ///         observable of bridges at a dry state, and for an effect that no run has alone
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Covariance of the errors of `mean`, a row and a column for each query.
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// Description of the coordinates in which a state lies outside the range of the runs, as in
    /// "friction 0.9 is above 0.6"; empty where it lies inside. Flow slower than any run does not
    /// count as outside: it is extrapolated, with its error.
    std::string beyond(const FlowState& state) const;

    /// Training runs, with and without effects.
    const std::vector<dem::RunResult>& runs() const { return plain_.runs(); }

    /// Covariance of the noise of a run's stress ratio and solid fraction, their deviations from a
    /// much longer run [1].
    Eigen::Matrix2d noise(const dem::RunResult& run) const { return plain_.noise(run); }
    /// Variance of the noise of one observable of a run, in the square of the observable's unit.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const {
        return plain_.noise_variance(run, which);
    }

  private:
    /// Response of an observable to an effect, trained at the first call.
    const EffectResponse& response_to(const std::string& effect, dem::Observable which) const;
    /// Trains the response of an observable to an effect.
    /// @throws std::invalid_argument where no run has this effect alone
    std::unique_ptr<const EffectResponse> learned(const std::string& effect,
                                                  dem::Observable which) const;
    struct Affected;
    /// Queries whose states have effects, grouped by the response that they need.
    std::vector<Affected> affected(const std::vector<Query>& queries) const;

    /// Responses by effect and observable, each trained when it is first needed, once for all
    /// threads.
    struct Responses {
        struct Response {
            std::once_flag once;
            std::unique_ptr<const EffectResponse> learned;
        };
        std::mutex mutex;  ///< guards the map `all`, whose entries keep their addresses
        std::map<std::pair<std::string, dem::Observable>, Response> all;
    };
    PlainEmulator plain_;
    std::unique_ptr<Responses> responses_ = std::make_unique<Responses>();
};

}  // namespace pendular
