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

/// Emulator: Gaussian processes trained on simulation runs. They predict the observables at states
/// of steady shear between those of the training runs, with standard errors. A `PlainEmulator`
/// predicts grains without effects. For each effect on grains, an `EffectResponse`, trained on the
/// runs that have this effect alone, predicts how the effect changes the observables; the changes
/// by several effects add up. A further `EffectResponse`, trained on runs of other stiffness
/// numbers, predicts the change from the stiffness number of the `PlainEmulator` to that of the
/// requested state. Derivatives with respect to friction, inertial number, reduced pressure and
/// bridge volume include the change with stiffness but omit the changes by effects. Predictions
/// never change after construction, so that several threads may query the emulator at once.
class Emulator {
  public:
    /// Takes training runs and hyperparameters. Each Gaussian process is trained when it is first
    /// needed, and missing hyperparameters are then fitted.
    /// @param stiffness_number stiffness number, within a factor 2, of the runs that train the
    ///        `PlainEmulator` [1]
    /// @throws std::invalid_argument if none of the runs can serve as a training run
    Emulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
             double stiffness_number = emulated::reference_stiffness);

    /// Returns an emulator with the same hyperparameters (amplitudes and lengths of its Gaussian
    /// processes), trained on the runs of this emulator and the runs `more`.
    Emulator with(const std::vector<dem::RunResult>& more) const;

    /// Hyperparameters that were given at construction or have been fitted since, by observable.
    EmulatorHyperparameters hyperparameters() const { return plain_.hyperparameters(); }

    /// Returns the result of each query: the predicted value of its observable, in the unit of the
    /// observable, or the derivative that the query names.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, if the
    ///         observable describes liquid bridges but the state is dry, or if the state has an
    ///         effect that no run has as its only effect
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Returns, for each query, by how much effects on grains and stiffness change the prediction
    /// of `mean`, in the unit of the prediction. The change is that from grains without effects and
    /// with the stiffness number of the runs that train the `PlainEmulator`.
    /// @throws std::invalid_argument if the state of a query has an effect that no run has as its
    ///         only effect
    Eigen::VectorXd changes_by_causes(const std::vector<Query>& queries) const;
    /// Whether the prediction at a state of steady shear differs from that of the `PlainEmulator`:
    /// the state has effects on grains, or a stiffness number other than that of the
    /// `PlainEmulator`.
    bool changes(const FlowState& state) const;
    /// Covariance of the errors of the predictions that `mean` returns, one row and one column for
    /// each query. The prediction for a state x with an effect is f(x) + d(x), with the prediction
    /// f without the effect and the change d by the effect. The predictor of d is trained on the
    /// differences (simulated value - f) at the states X of the runs with the effect, so that the
    /// errors of f and d are correlated:
    ///     error = e(x) - W e(X) + error of d at given f,
    /// with the error e of f, and the weights W with which d depends on the training differences.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, if the
    ///         observable describes liquid bridges but the state is dry, or if the state has an
    ///         effect that no run has as its only effect
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// Returns a text that names the numbers of a state of steady shear that lie outside their
    /// range in the training runs, as in "friction 0.9 is above 0.6". The numbers are friction,
    /// inertial number and, for a wet state, reduced pressure and bridge volume. The text is empty
    /// if all lie inside. An inertial number below that of all runs does not count as outside,
    /// since the emulator extrapolates to slower flow and states the error.
    std::string beyond(const FlowState& state) const;

    /// Simulation runs on which the emulator is trained, with and without effects on grains.
    const std::vector<dem::RunResult>& runs() const { return plain_.runs(); }

    /// Whether training runs of other stiffness numbers determine how predictions change with
    /// stiffness. If not, predictions hold for the stiffness number of the `PlainEmulator`, and
    /// only the changes of solid fraction and overlap that are known without training can be
    /// applied.
    bool knows_stiffness() const { return knows_stiffness_; }
    /// Whether the emulator can predict how the effect `name` changes the flow: a training run has
    /// it as its only effect, with values that models of studies can have.
    bool knows(const std::string& name) const;

    /// Covariance of the noise of a run's stress ratio and solid fraction [1], in this order. The
    /// noise is the difference between the run and the mean of many runs of the same parameters.
    Eigen::Matrix2d noise(const dem::RunResult& run) const { return plain_.noise(run); }
    /// Variance of the noise of one observable of a run, in the square of the observable's unit:
    /// the squared standard error times the fitted noise factor, plus the squared between-run
    /// scatter.
    double noise_variance(const dem::RunResult& run, dem::Observable which) const {
        return plain_.noise_variance(run, which);
    }

  private:
    static inline const std::string stiffness_name = "stiffness number";
    /// Calls `use(name, size, place)` for each cause (an effect on grains, or a stiffness number
    /// that differs from that of the `PlainEmulator`) that changes the observable `which` at a
    /// state of steady shear from the prediction of the `PlainEmulator`, effects first. `name`:
    /// name of the effect, or `stiffness_name`; `size`: factor to which the change is proportional;
    /// `place`: coordinates at which the change is evaluated.
    template <typename Use>
    void each_cause(const FlowState& state, dem::Observable which, const Use& use) const;
    /// Whether the stiffness number of a state of steady shear changes predictions: it differs from
    /// that of the `PlainEmulator`, and `knows_stiffness` is true.
    bool stiffened(const FlowState& state) const;
    /// Whether a run trains the predictor of how the cause `name` changes an observable. For an
    /// effect, the run has this effect alone, at any stiffness number, and is neutral in parameters
    /// that only simulations have. For stiffness, the run has another stiffness number than the
    /// `PlainEmulator` and no effects.
    bool trains(const dem::RunResult& run, const std::string& name, dem::Observable which) const;

    /// Predictor of how one cause (an effect or another stiffness number) changes an observable. It
    /// is trained on runs with the cause minus predictions without the cause, which it keeps.
    struct LearnedResponse {
        EffectResponse response;
        /// Queries at the state of each training run, without the cause (effect or other stiffness
        /// number).
        PlainEmulator::PreparedQueries plain;
        /// Scale of the observable at each training run (`emulated::Unit::size`).
        Eigen::VectorXd sizes;
        /// Covariance of the errors of the predictions for the queries `plain`, divided by the
        /// product of the scales `sizes`.
        Eigen::MatrixXd plain_error;
    };
    /// Returns the predictor of how the cause `name` (an effect or the stiffness number) changes
    /// the observable `which`; it is trained at the first call.
    /// @throws std::invalid_argument if no run has `name` as its only cause of a change
    const LearnedResponse& response_to(const std::string& name, dem::Observable which) const;
    /// Trains a predictor of how the cause `name` (an effect or the stiffness number) changes the
    /// observable `which`, on the runs that have `name` as their only cause of a change.
    /// @throws std::invalid_argument if no run has `name` as its only cause of a change
    std::unique_ptr<const LearnedResponse> learned(const std::string& name,
                                                   dem::Observable which) const;
    /// Covariance of the errors of the predictions without causes (effects, other stiffness)
    /// between the training states of the predictor `a` (rows) and those of the predictor `b`
    /// (columns), computed once; empty if these errors are independent.
    const Eigen::MatrixXd& training_covariance(const LearnedResponse& a,
                                               const LearnedResponse& b) const;
    struct Affected;
    /// Groups the queries whose prediction a cause (an effect or another stiffness number) changes,
    /// by the predictor that they need: one for each cause and observable. Queries for derivatives
    /// need only the predictors of the change with stiffness.
    std::vector<Affected> affected(const std::vector<Query>& queries) const;

    /// Predictors of how each cause (an effect or another stiffness number) changes each
    /// observable. Each predictor is trained when it is first needed, once for all threads.
    struct Responses {
        struct Response {
            std::once_flag once;
            std::unique_ptr<const LearnedResponse> learned;
        };
        /// Guards both maps of predictors, whose entries keep their addresses.
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
