#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calib/emulator/emulated_state.h"
#include "calib/emulator/known_range.h"
#include "sim/closures/closure_values.h"
#include "sim/runs/store/run_store.h"
#include "workflow/fit_runs.h"
#include "workflow/requested_state.h"

namespace pendular {

/// Observables, such as the stress ratio, that an emulator (which interpolates simulations)
/// predicts at one state of steady shear. The emulator is trained on the runs of the atlas (the
/// simulations supplied with Pendular) and of the store (the user's file of simulations).
struct StatePrediction {
    FlowState state;
    /// Predicted values of the observables at the state, with their standard errors.
    std::vector<EmulatedObservable> observables;
    /// Stiffness number of the grains for which the predictions hold [1].
    double stiffness_number = 1000;
    /// Text on the quantities of the state that lie outside their ranges in the emulator's training
    /// runs, such as "friction 0.9 is above 0.6". The quantities are friction coefficient, inertial
    /// number and, for a wet state, reduced pressure and bridge volume. Empty if no quantity is
    /// outside its range. An inertial number below its range counts as inside.
    std::string beyond;
    /// Number of simulation runs on which the emulator is trained.
    std::size_t runs = 0;
    /// Values of the closures (analytical formulas) of Badetti et al. (2018), computed from the
    /// predicted observables. Empty for a dry state.
    std::optional<closures::ClosureValues> closures = {};
};

/// Quantity that varies along a curve of predicted states, with its first and last value.
struct VariedQuantity {
    /// Name of the quantity: "friction", "inertial_number", "reduced_pressure", "bridge_volume" or
    /// "liquid_content".
    std::string name;
    /// First and last value of the varied quantity [1].
    double from = 0, to = 0;
    /// Number of values that the varied quantity takes along the curve.
    int points = 60;
    /// Whether the values of the quantity are evenly spaced in the logarithm.
    bool logarithmic = false;

    /// Parses the name and the range of a varied quantity from a text such as
    /// "reduced-pressure=0.5:10". Values of the friction coefficient, and of a range that begins at
    /// 0 or below, are evenly spaced. All other values are evenly spaced in the logarithm.
    /// @param points number of values along the range
    /// @throws InputError if the text has another form, if the range does not increase, or if
    ///         `points` is below 2
    static VariedQuantity parsed(const std::string& text, int points);
    /// Returns value k of the varied quantity [1], for k from 0 (`from`) to points - 1 (`to`).
    double at(int k) const;
    /// Sets the varied quantity of a requested state to a value [1].
    void set(RequestedState& requested, double value) const;
};

/// Predictions along a curve of states of steady shear that differ in one quantity. States outside
/// the range of the earlier simulation runs are left out.
struct PredictionCurve {
    std::string variable;    ///< name of the varied quantity (`VariedQuantity::name`)
    std::vector<double> at;  ///< value of the varied quantity at each predicted state [1]
    /// States of steady shear for which the curve has predictions, in the order of `at`.
    std::vector<FlowState> states;
    /// Predicted observables of each state, in the order of `states`.
    std::vector<std::vector<EmulatedObservable>> observables;
    /// Values of the closures (analytical formulas) of Badetti et al. (2018), computed from the
    /// predicted observables, in the order of `states`. Empty for dry states.
    std::vector<closures::ClosureValues> closures;
    /// Stiffness number of the grains for which the predictions hold [1].
    double stiffness_number = 1000;
    /// Number of states of the curve that are left out, since they are outside the range of the
    /// earlier simulation runs.
    int left_out = 0;
    /// Reason why the first state that was left out cannot be predicted. Empty if no state was left
    /// out.
    std::string why_left_out;
};

/// Predictor of steady shear at any state from the runs of the atlas (the simulations supplied with
/// Pendular) and of a store (the user's file of simulations), without a study and without new runs.
class StatePredictor {
  public:
    /// Trains an emulator (which interpolates simulations) on the earlier runs of the atlas (the
    /// simulations supplied with Pendular) and of `store`.
    /// @param fidelity simulation settings of the runs that messages and `run_for` suggest for
    ///        states that cannot be predicted; they also set the smallest number of grains (at most
    ///        1000) of the training runs
    /// @param store user's file of simulations; null: only the atlas is used
    /// @param stiffness_number stiffness number of the grains to predict [1]
    /// @param training runs of an earlier result, on which the emulator is trained in place of all
    ///        runs of atlas and store; null: atlas and store
    /// @throws InputError if there are too few earlier runs to train an emulator, or if the
    ///         stiffness number is below 100
    StatePredictor(const Fidelity& fidelity, const RunStore* store, double stiffness_number,
                   const TrainingRuns* training = nullptr);
    StatePredictor(const StatePredictor&) = delete;
    StatePredictor& operator=(const StatePredictor&) = delete;

    /// Checks that solid fractions can be predicted for grains of the stiffness number
    /// `stiffness_number` [1], which must be 100 or more.
    /// @throws InputError if the stiffness number is below 100
    static void check_stiffness_number(double stiffness_number);

    const Emulator& emulator() const { return emulator_; }
    double stiffness_number() const { return stiffness_number_; }

    /// Whether the earlier simulation runs allow a prediction at a requested state. The state must
    /// lie within the convex hull of the states of the runs. The standard errors of the predictions
    /// must be small enough, and the predicted values must be physical (`KnownRange`).
    /// @throws InputError if the state is wet but no earlier run is wet, or if the state is dry but
    ///         no earlier run is dry
    bool supports(const RequestedState& requested) const;
    /// Predicts all observables, such as stress ratio, solid fraction and coordination numbers, at
    /// a requested state of steady shear.
    /// @throws InputError if the state is outside the range of the earlier simulation runs (the
    ///         message names the nearest state within the range), or if the predicted solid
    ///         fraction is not that of a dense flow (0.4 to 0.74)
    StatePrediction at(const RequestedState& requested) const;
    /// Predicts all observables, such as the stress ratio, along a curve of states: the state
    /// `requested`, with the varied quantity set to each of its values. States outside the range of
    /// the earlier simulation runs are left out.
    /// @throws InputError if fewer than two states of the curve can be predicted, or if a predicted
    ///         solid fraction is not that of a dense flow (0.4 to 0.74)
    PredictionCurve along(RequestedState requested, const VariedQuantity& varied) const;

    /// Returns the values of the closures (analytical formulas) of Badetti et al. (2018) for a wet
    /// simulation run. The values are computed from the observables of the run and from the stress
    /// ratio that the emulator predicts for dry grains with equal friction coefficient, inertial
    /// number and stiffness number. Empty if the run is dry, if the earlier runs do not support
    /// this prediction, if the damping of the contacts is not the default damping, or if an effect
    /// of the run also changes dry flow.
    std::optional<closures::ClosureValues> closures_of(const dem::RunResult& run) const;

    /// Returns the parameters of the run that simulates a requested state, for a state that cannot
    /// be predicted from the earlier runs.
    /// @throws InputError if the state cannot be simulated
    dem::RunParameters run_for(const RequestedState& requested) const;

  private:
    /// Returns the requested state in the coordinates of the emulator (friction coefficient,
    /// inertial number, inverse reduced pressure, bridge volume), for grains of the stiffness
    /// number `stiffness_number_`.
    FlowState state_of(RequestedState requested) const;
    std::vector<EmulatedObservable> observables_at(const FlowState& state) const;
    std::string unsupported(const RequestedState& requested, const FlowState& state,
                            const std::string& why) const;

    Fidelity fidelity_;
    double stiffness_number_;
    Emulator emulator_;
    KnownRange known_;
};

}  // namespace pendular
