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

/// Emulator: Gaussian processes that are trained on simulation runs and predict the observables,
/// with standard errors, at states of steady shear that were not simulated. A `PlainEmulator`
/// predicts the flow of grains without effects. For each effect on grains, an `EffectResponse` adds
/// the change by the effect. A further `EffectResponse` adds the change from the stiffness number
/// of the `PlainEmulator` to the stiffness number of the state.
///
/// Derivatives with respect to friction coefficient, inertial number, reduced pressure and bridge
/// volume omit the changes by effects. Several threads may query one emulator at once.
class Emulator {
  public:
    /// Makes an emulator from training runs and hyperparameters. Each Gaussian process is trained
    /// when a prediction first needs the process. If an observable has no hyperparameters, the
    /// emulator fits them before the training.
    /// @param hyperparameters hyperparameters (amplitudes, correlation lengths and noise of the
    ///        Gaussian processes) for each observable; may be empty
    /// @param stiffness_number stiffness number [1] of the runs on which the `PlainEmulator`, for
    ///        grains without effects, is trained, with a tolerance of a factor of 2
    /// @throws std::invalid_argument if none of the runs can serve as a training run
    Emulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
             double stiffness_number = emulated::reference_stiffness);

    /// Returns a new emulator, trained on the runs of the present emulator and on the runs `more`.
    /// The new emulator has the hyperparameters (amplitudes, correlation lengths and noise of the
    /// Gaussian processes) of the present emulator.
    Emulator with(const std::vector<dem::RunResult>& more) const;

    /// Returns all hyperparameters that were given at construction or have been fitted since, with
    /// the observable as the key.
    EmulatorHyperparameters hyperparameters() const { return plain_.hyperparameters(); }

    /// Returns the result of each query: the predicted value of the observable, in the unit of the
    /// observable, or the derivative that the query names.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, if the
    ///         observable describes liquid bridges but the state is dry, or if the emulator cannot
    ///         predict an effect of the state (`knows`)
    Eigen::VectorXd mean(const std::vector<Query>& queries) const;
    /// Returns, for each query, the change that effects on grains and stiffness cause, in the unit
    /// of the query's result: the result of mean() minus the prediction of the `PlainEmulator`,
    /// which describes grains without effects at one stiffness number. For a query for a
    /// derivative, the result contains only the change by stiffness.
    /// @throws std::invalid_argument if the emulator cannot predict an effect of a queried state
    ///         (`knows`)
    Eigen::VectorXd changes_by_causes(const std::vector<Query>& queries) const;
    /// Whether the prediction at a state of steady shear differs from the prediction of the
    /// `PlainEmulator`, which describes grains without effects. The predictions differ if the state
    /// has effects on grains. If knows_stiffness() is true, the predictions also differ if the
    /// stiffness number of the state differs from that of the `PlainEmulator`.
    bool changes(const FlowState& state) const;
    /// Returns the covariance of the errors of the predictions that mean() returns, with a row and
    /// a column for each query. The prediction for a state x with an effect is f(x) + d(x), with
    /// the prediction f without the effect and the change d by the effect. The error of the
    /// prediction is
    ///     e(x) - W e(X) + error of d at given f,
    /// with the error e of f, the states X of the runs with the effect, and the weights W with
    /// which d depends on the training data (simulated value - f) at X.
    /// @throws std::invalid_argument if no training run has a value of a queried observable, if the
    ///         observable describes liquid bridges but the state is dry, or if the emulator cannot
    ///         predict an effect of the state (`knows`)
    Eigen::MatrixXd covariance(const std::vector<Query>& queries) const;

    /// Describes which numbers of a state of steady shear lie outside their range in the training
    /// runs, such as "friction 0.9 is above 0.6". The compared numbers are friction coefficient,
    /// inertial number and, for a wet state, reduced pressure and bridge volume. An inertial number
    /// below the range counts as inside, since the emulator extrapolates to slower flow. The text
    /// is empty if all numbers lie inside.
    std::string beyond(const FlowState& state) const;

    /// Returns the simulation runs on which the emulator is trained, with and without effects on
    /// grains.
    const std::vector<dem::RunResult>& runs() const { return plain_.runs(); }

    /// Whether the emulator has training runs that determine how predictions change with stiffness:
    /// runs without effects whose stiffness number differs from that of the `PlainEmulator` (for
    /// grains without effects) by more than a factor of 2. If not, predictions hold for the
    /// stiffness number of the `PlainEmulator`. Then only the changes of solid fraction and overlap
    /// that are known without training can be applied.
    bool knows_stiffness() const { return knows_stiffness_; }
    /// Whether the emulator can predict how the effect `name` changes the flow. For this
    /// prediction, a training run must have the effect as its only effect. Parameters of the effect
    /// that models of studies never fit (`EffectParameter::only_simulated`) must be neutral in the
    /// run.
    bool knows(const std::string& name) const;

    /// Returns the covariance of the noise of the stress ratio and the solid fraction of a run [1],
    /// in this order. The noise is the difference between the run and the mean of many runs of
    /// equal parameters.
    Eigen::Matrix2d noise(const dem::RunResult& run) const { return plain_.noise(run); }
    /// Returns the variance of the noise of one observable of a run, in the square of the unit of
    /// the observable. The variance is the squared standard error of the run times the fitted noise
    /// factor, plus the squared between-run scatter (standard deviation between runs of equal
    /// parameters beyond the stated noise).
    double noise_variance(const dem::RunResult& run, dem::Observable which) const {
        return plain_.noise_variance(run, which);
    }

  private:
    static inline const std::string stiffness_name = "stiffness number";
    /// Calls `use(name, size, place)` for each cause by which the observable `which` at a state of
    /// steady shear differs from the prediction of the `PlainEmulator`. First come the effects on
    /// grains, then a differing stiffness number. `name` is the name of the effect, or
    /// `stiffness_name`. The change is proportional to `size`. `place` contains the coordinates at
    /// which the change is evaluated.
    template <typename Use>
    void each_cause(const FlowState& state, dem::Observable which, const Use& use) const;
    /// Whether the stiffness number of a state of steady shear changes predictions. Predictions
    /// change if the stiffness number differs from that of the `PlainEmulator` and
    /// knows_stiffness() is true.
    bool stiffened(const FlowState& state) const;
    /// Whether a run trains the predictor of the change of the observable `which` by the cause
    /// `name`. A cause is an effect or a differing stiffness number. The run must have a value of
    /// the observable. For an effect, the run must have only this effect, and the parameters that
    /// no model of a study fits (`EffectParameter::only_simulated`) must be neutral. For stiffness,
    /// the run must have no effects, and its stiffness number must differ from that of the
    /// `PlainEmulator` by more than a factor of 2.
    bool trains(const dem::RunResult& run, const std::string& name, dem::Observable which) const;

    /// Predictor of how one cause (an effect, or a differing stiffness number) changes an
    /// observable, with data for the errors of the predictor. The predictor is trained on the
    /// values of runs with the cause minus the predictions without the cause.
    struct LearnedResponse {
        EffectResponse response;
        /// Queries for the observable at the state of each training run, without effects and at the
        /// stiffness number of the `PlainEmulator`.
        PlainEmulator::PreparedQueries plain;
        /// Scale of the observable (`emulated::Unit::size`) at the state of each training run.
        Eigen::VectorXd sizes;
        /// Covariance of the errors of the predictions for the queries `plain`. Each entry is
        /// divided by the scales `sizes` of its row and its column.
        Eigen::MatrixXd plain_error;
    };
    /// Returns the predictor of how the cause `name` (an effect, or the stiffness number) changes
    /// the observable `which`. The first call trains the predictor.
    /// @throws std::invalid_argument if no run can train the predictor
    const LearnedResponse& response_to(const std::string& name, dem::Observable which) const;
    /// Trains a predictor of how the cause `name` (an effect, or the stiffness number) changes the
    /// observable `which`. The training runs have `name` as their only effect or, for the stiffness
    /// number, no effect.
    /// @throws std::invalid_argument if no run can train the predictor
    std::unique_ptr<const LearnedResponse> learned(const std::string& name,
                                                   dem::Observable which) const;
    /// Returns the covariance of the prediction errors of the `PlainEmulator` at the training
    /// states of the predictor `a` (rows) with the prediction errors at the training states of the
    /// predictor `b` (columns). The first call computes and stores the covariance. The matrix is
    /// empty if the errors are independent.
    const Eigen::MatrixXd& training_covariance(const LearnedResponse& a,
                                               const LearnedResponse& b) const;
    struct Affected;
    /// Finds the queries whose prediction a cause (an effect, or a differing stiffness number)
    /// changes, and groups the queries by the predictor of the change. There is a predictor for
    /// each pair of cause and observable. Queries for derivatives need only the predictors of the
    /// change with stiffness.
    std::vector<Affected> affected(const std::vector<Query>& queries) const;

    /// Predictors of how each cause (an effect, or a differing stiffness number) changes each
    /// observable. Each predictor is trained when it is first needed, once for all threads.
    struct Responses {
        struct Response {
            std::once_flag once;
            std::unique_ptr<const LearnedResponse> learned;
        };
        /// Lock that guards the maps `all` and `training_covariances`. The entries of the maps keep
        /// their addresses.
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
