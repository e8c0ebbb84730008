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

/// Emulator: Gaussian processes that are trained on simulation runs and predict observables, with
/// standard errors, at states that were not simulated. A `PlainEmulator` predicts the flow of
/// grains without effects at one stiffness number. For each cause of a change (each effect on
/// grains, and a stiffness number that differs from that of the `PlainEmulator`), an
/// `EffectResponse` adds the change.
///
/// The prediction at a state x with an effect is f(x) + d(x), with the prediction f without the
/// effect and the change d by the effect. Its error is
///     e(x) - W e(X) + error of d at given f,
/// with the error e of f, the states X of the runs with the effect, and the weights W with which d
/// depends on the training data (simulated value - f) at X.
///
/// Derivatives with respect to friction coefficient, inertial number, reduced pressure and bridge
/// volume omit the changes by effects. Several threads may query one emulator at once.
class Emulator {
  public:
    /// Makes an emulator from training runs. Each Gaussian process is trained when first needed,
    /// after the fit of its hyperparameters if `hyperparameters` lacks them.
    /// @param stiffness_number of the runs of the `PlainEmulator` [1], to a factor of 2
    /// @throws std::invalid_argument if none of the runs can serve as a training run
    Emulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
             double stiffness_number = emulated::reference_stiffness);

    /// Returns an emulator trained on the present runs and `more`, with the present
    /// hyperparameters.
    Emulator with(const std::vector<dem::RunResult>& more) const;

    /// Returns all hyperparameters that were given at construction or have been fitted since.
    EmulatorHyperparameters hyperparameters() const { return plain_.hyperparameters(); }

    /// Returns the result of each query, in the unit of the observable.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, if the
    ///         observable describes liquid bridges but the state is dry, or if the emulator cannot
    ///         predict an effect of the state (`knows`)
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Returns, for each query, the result of mean() minus the prediction of the `PlainEmulator`.
    /// For a query for a derivative, it contains only the change by stiffness.
    /// @throws std::invalid_argument if it cannot predict an effect of a queried state (`knows`)
    Eigen::VectorXd changes_by_causes(const std::vector<Query>& queries) const;
    /// Whether the prediction at a state differs from that of the `PlainEmulator`: the state has
    /// effects on grains or, if knows_stiffness(), another stiffness number.
    bool changes(const FlowState& state) const;
    /// Returns the covariance of the errors of mean(), with a row and a column for each query.
    /// @throws std::invalid_argument as mean()
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// Returns which numbers of a state lie outside their range in the training runs, such as
    /// "friction 0.9 is above 0.6": friction coefficient, inertial number and, for a wet state,
    /// reduced pressure and bridge volume. An inertial number below the range counts as inside,
    /// since the emulator extrapolates to slower flow. Empty if all numbers lie inside.
    std::string beyond(const FlowState& state) const;

    /// Returns the training runs, with and without effects on grains.
    const std::vector<dem::RunResult>& runs() const { return plain_.runs(); }

    /// Whether training runs determine how predictions change with stiffness: runs without effects
    /// whose stiffness number differs from that of the `PlainEmulator` by more than a factor of 2.
    /// If not, predictions hold for the stiffness number of the `PlainEmulator`, and only the
    /// changes of solid fraction and overlap that are known without training can be applied.
    bool knows_stiffness() const { return knows_stiffness_; }
    /// Whether the emulator can predict how the effect `name` changes the flow: a training run must
    /// have the effect as its only effect, with neutral values of the parameters that models of
    /// studies never fit (`EffectParameter::only_simulated`).
    bool knows(const std::string& name) const;

    /// Returns the covariance of the noise of the stress ratio and the solid fraction of a run [1]:
    /// of the difference between the run and the mean of many runs of equal parameters.
    Eigen::Matrix2d noise(const dem::RunResult& run) const { return plain_.noise(run); }
    /// Returns PlainEmulator::noise_variance().
    double noise_variance(const dem::RunResult& run, dem::Observable which) const {
        return plain_.noise_variance(run, which);
    }

  private:
    static inline const std::string stiffness_name = "stiffness number";
    /// Calls `use(name, size, place)` for each cause of a change of the observable `which` at a
    /// state: the effects on grains, then stiffness (`stiffness_name`). The change is proportional
    /// to `size`. `place` contains the coordinates at which it is evaluated.
    template <typename Use>
    void each_cause(const FlowState& state, dem::Observable which, const Use& use) const;
    /// Whether the stiffness number of a state changes predictions.
    bool stiffened(const FlowState& state) const;
    /// Whether a run trains the change of the observable `which` by the cause `name`. For an
    /// effect, see `knows`; for stiffness, see `knows_stiffness`.
    bool trains(const dem::RunResult& run, const std::string& name, dem::Observable which) const;

    /// Predictor of how one cause changes an observable, with data for its errors. The training
    /// values are those of runs with the cause minus the predictions without the cause.
    struct LearnedResponse {
        EffectResponse response;
        /// Queries for the observable at the states of the training runs, without the cause.
        PlainEmulator::PreparedQueries plain;
        Eigen::VectorXd sizes;        ///< scale `emulated::Unit::size` at each training state
        Eigen::MatrixXd plain_error;  ///< covariance of the errors of `plain`, over `sizes`
    };
    /// Returns the predictor of the change of `which` by `name`. The first call trains it.
    /// @throws std::invalid_argument if no run can train the predictor
    const LearnedResponse& response_to(const std::string& name, dem::Observable which) const;
    std::unique_ptr<const LearnedResponse> learned(const std::string& name,
                                                   dem::Observable which) const;
    /// Returns the covariance of the prediction errors of the `PlainEmulator` at the training
    /// states of `a` (rows) and of `b` (columns), computed once; empty if they are independent.
    const Eigen::MatrixXd& training_covariance(const LearnedResponse& a,
                                               const LearnedResponse& b) const;
    struct Affected;
    /// Returns the queries that a cause changes, grouped by predictor (pair of cause and
    /// observable). Queries for derivatives need only the predictors of the change with stiffness.
    std::vector<Affected> affected(const std::vector<Query>& queries) const;

    /// Predictors for each cause and observable, trained when needed, once for all threads.
    struct Responses {
        struct Response {
            std::once_flag once;
            std::unique_ptr<const LearnedResponse> learned;
        };
        /// Guards both maps, whose entries keep their addresses.
        std::mutex mutex;
        std::map<std::pair<std::string, dem::Observable>, Response> all;
        std::map<std::pair<const LearnedResponse*, const LearnedResponse*>, Eigen::MatrixXd>
            training_covariances;
    };
    PlainEmulator plain_;
    bool knows_stiffness_ = false;
    std::unique_ptr<Responses> responses_ = std::make_unique<Responses>();
};

}  // namespace pendular
