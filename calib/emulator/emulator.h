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

/// Emulator: Gaussian processes trained on simulation runs, which predict the observables of any
/// flow state between the training runs, with standard errors. A `PlainEmulator` predicts them for
/// grains without effects. For each effect on grains, an `EffectResponse` trained on the runs that
/// have this effect alone adds the change. Changes by several effects add up. An `EffectResponse`
/// trained on the runs of other stiffness numbers likewise adds the change from the stiffness
/// number of the `PlainEmulator` to that of the flow state. Derivatives of observables by friction,
/// inertial number, pressure or bridge volume are those of the `PlainEmulator`, with the
/// change with stiffness: they omit the effects. The predictions never change after construction:
/// any number of threads may query the emulator at once.
class Emulator {
  public:
    /// Takes training runs, with the arguments of `PlainEmulator`; each Gaussian process is trained
    /// when it is first needed.
    /// @throws std::invalid_argument where no run can serve as a training run
    Emulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
             double stiffness_number = emulated::reference_stiffness);

    /// Returns an emulator trained on the runs of this one and the runs `more`, with this
    /// emulator's hyperparameters.
    Emulator with(const std::vector<dem::RunResult>& more) const;

    /// Hyperparameters of the observables for which they were given at construction or fitted
    /// since.
    EmulatorHyperparameters hyperparameters() const { return plain_.hyperparameters(); }

    /// Predicted value of the observable of each query, in its unit, or the derivative that the
    /// query names.
    /// @throws std::invalid_argument for an observable of which no training run has a value, for an
    ///         observable of bridges at a dry state, and for an effect that no run has alone
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Part of the answers that `mean` returns from effects on grains and from a stiffness number
    /// other than that of the `PlainEmulator`, in the unit of each answer.
    /// @throws std::invalid_argument for an effect that no run has alone
    Eigen::VectorXd changes_by_causes(const std::vector<Query>& queries) const;
    /// Whether effects on grains or stiffness change predictions at a flow state.
    bool changes(const FlowState& state) const;
    /// Covariance of the errors of the predictions that `mean` returns, a row and a column for each
    /// query. A prediction with an effect is the sum of the prediction f without it and of the
    /// response, which is trained on differences d = run - f at the states X of the runs with the
    /// effect. An error of f enters both with opposite signs, so that the sum is treated jointly:
    ///     error = e(at) - W e(X) + error of the response at given f,
    /// with the error e of f and the weights W of the differences in the response.
    /// @throws std::invalid_argument as `mean` does
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// Text on the friction, inertial number, reduced pressure and bridge volume of a flow state
    /// that lie outside their ranges in the training runs, as in "friction 0.9 is above 0.6"; empty
    /// where none does. Flow slower than any run does not count as outside: it is extrapolated,
    /// with its error.
    std::string beyond(const FlowState& state) const;

    /// Training runs, with and without effects.
    const std::vector<dem::RunResult>& runs() const { return plain_.runs(); }

    /// Whether runs of another stiffness number than that of the `PlainEmulator` train the change
    /// of predictions with stiffness. Without any, predictions hold for that stiffness number, but
    /// for the known change of solid fraction and overlap.
    bool knows_stiffness() const { return knows_stiffness_; }

    /// Covariance of the noise of a run's stress ratio and solid fraction [1], in this order; noise
    /// is the deviation from a much longer run.
    Eigen::Matrix2d noise(const dem::RunResult& run) const { return plain_.noise(run); }
    /// Variance of the noise of one observable of a run, in the square of the observable's unit.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const {
        return plain_.noise_variance(run, which);
    }

  private:
    static inline const std::string stiffness_name = "stiffness number";
    /// Calls `use(name, size, place)` for each cause that changes the observable `which` at a flow
    /// state from the prediction of the `PlainEmulator`: each effect on grains, then another
    /// stiffness number. `name` is that of the effect or `stiffness_name`, `size` the factor to
    /// which the response is proportional, `place` the coordinates at which it is evaluated.
    template <typename Use>
    void each_cause(const FlowState& state, dem::Observable which, const Use& use) const;
    /// Whether stiffness changes predictions at a flow state: only if `knows_stiffness`.
    bool stiffened(const FlowState& state) const;
    /// Whether a run trains the response of an observable to the cause `name`: another stiffness
    /// number without effects, or this effect alone, at any stiffness number.
    bool trains(const dem::RunResult& run, const std::string& name, dem::Observable which) const;

    /// Response (predicted change) of an observable to a cause, with the predictions without the
    /// cause from which its training changes follow.
    struct LearnedResponse {
        EffectResponse response;
        PlainEmulator::PreparedQueries plain;  ///< state of each training run, without causes
        Eigen::VectorXd sizes;        ///< scale of the observable there (`emulated::Unit::size`)
        Eigen::MatrixXd plain_error;  ///< covariance of the errors at `plain`, in units of `sizes`
    };
    /// Response of an observable to the cause `name`, trained at the first call.
    /// @throws std::invalid_argument where no run has this cause alone
    const LearnedResponse& response_to(const std::string& name, dem::Observable which) const;
    /// Returns the response of an observable to the cause `name`, trained on the runs that have
    /// this cause alone.
    /// @throws std::invalid_argument where no run does
    std::unique_ptr<const LearnedResponse> learned(const std::string& name,
                                                   dem::Observable which) const;
    /// Covariance of the errors of the predictions without causes at the training states of two
    /// responses, computed once; empty where these errors are independent.
    const Eigen::MatrixXd& training_covariance(const LearnedResponse& a,
                                               const LearnedResponse& b) const;
    struct Affected;
    /// Queries for values that a cause changes, grouped by the response (of one observable to one
    /// cause) that they need. A query for a derivative is left out.
    std::vector<Affected> affected(const std::vector<Query>& queries) const;

    /// Responses of observables to causes of change, by cause and observable, each trained when it
    /// is first needed, once for all threads.
    struct Responses {
        struct Response {
            std::once_flag once;
            std::unique_ptr<const LearnedResponse> learned;
        };
        std::mutex mutex;  ///< guards both maps, whose entries keep their addresses
        std::map<std::pair<std::string, dem::Observable>, Response> all;
        std::map<std::pair<const LearnedResponse*, const LearnedResponse*>, Eigen::MatrixXd>
            training_covariances;
    };
    PlainEmulator plain_;
    bool knows_stiffness_ = false;
    std::unique_ptr<Responses> responses_ = std::make_unique<Responses>();
};

}  // namespace pendular
