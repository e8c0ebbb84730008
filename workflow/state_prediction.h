#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calib/emulator/emulated_state.h"
#include "calib/emulator/known_range.h"
#include "sim/closures/closure_values.h"
#include "sim/runs/store/run_store.h"
#include "workflow/json/training_runs.h"
#include "workflow/requested_state.h"

namespace pendular {

/// Observables, such as the stress ratio, that an emulator predicts at one state of steady shear.
struct StatePrediction {
    FlowState state;
    std::vector<EmulatedObservable> observables;
    double stiffness_number = 1000;  ///< [1]
    /// Quantities of the state outside their ranges in the training runs, such as "friction 0.9 is
    /// above 0.6"; empty: none. Looked at are friction coefficient, inertial number and, for a wet
    /// state, reduced pressure and bridge volume. An inertial number below its range counts as
    /// inside.
    std::string beyond;
    std::size_t runs = 0;  ///< number of training runs
    /// Closures of Badetti et al. (2018) from the predicted observables. Empty for a dry state.
    std::optional<closures::ClosureValues> closures = {};
};

/// Quantity that varies along a curve of predicted states.
struct VariedQuantity {
    /// "friction", "inertial_number", "reduced_pressure", "bridge_volume" or "liquid_content".
    std::string name;
    double from = 0, to = 0;   ///< first and last value [1]
    int points = 60;           ///< number of values along the curve
    bool logarithmic = false;  ///< whether the values are evenly spaced in the logarithm

    /// Parses a text such as "reduced-pressure=0.5:10". Values of the friction coefficient, and of
    /// a range that begins at 0 or below, are evenly spaced, all others in the logarithm.
    /// @throws InputError if the text has another form, if the range does not increase or its ends
    ///         differ by more than a factor of 1e12, or if `points` is not from 2 to 10 000
    static VariedQuantity parsed(const std::string& text, int points);
    /// Returns value k [1], from k = 0 (`from`) to points - 1 (`to`).
    double at(int k) const;
    /// Sets the varied quantity of a requested state [1].
    void set(RequestedState& requested, double value) const;
};

/// Predictions along a curve of states that differ in one quantity. States outside the range of the
/// earlier simulation runs are left out; the lists have one entry for each other state.
struct PredictionCurve {
    std::string variable;    ///< `VariedQuantity::name`
    std::vector<double> at;  ///< values of the varied quantity [1]
    std::vector<FlowState> states;
    std::vector<std::vector<EmulatedObservable>> observables;
    std::vector<closures::ClosureValues> closures;  ///< from the observables; empty if dry
    double stiffness_number = 1000;                 ///< [1]
    int left_out = 0;          ///< number of states outside the range of the runs
    std::string why_left_out;  ///< reason for the first of these states
};

/// Predictor of steady shear at any state from the runs of atlas and store, without a study and
/// without new runs.
class StatePredictor {
  public:
    /// Trains an emulator on the runs of the atlas and of `store` (null: only the atlas).
    /// @param fidelity settings of the runs that messages and `run_for` suggest for states that
    ///        cannot be predicted; also sets the smallest number of grains (at most 1000) of the
    ///        training runs
    /// @param stiffness_number stiffness number of the grains to predict [1]
    /// @param training runs used in place of all runs of atlas and store; null: atlas and store
    /// @throws InputError if there are too few earlier runs to train an emulator, or if the
    ///         stiffness number is below 100
    StatePredictor(const Fidelity& fidelity, const RunStore* store, double stiffness_number,
                   const TrainingRuns* training = nullptr);
    StatePredictor(const StatePredictor&) = delete;
    StatePredictor& operator=(const StatePredictor&) = delete;

    /// Checks that solid fractions can be predicted for grains of a stiffness number [1].
    /// @throws InputError if the stiffness number is below 100
    static void check_stiffness_number(double stiffness_number);

    const Emulator& emulator() const { return emulator_; }
    double stiffness_number() const { return stiffness_number_; }

    /// Whether the earlier runs allow a prediction at a state. The state must lie within the convex
    /// hull of the states of the runs, the standard errors of the predictions must be small enough,
    /// and the predicted values physical (`KnownRange`).
    /// @throws InputError if the state is wet but no earlier run is wet, or dry but no run is dry
    bool supports(const RequestedState& requested) const;
    /// Predicts all observables at a requested state.
    /// @throws InputError if the state is outside the range of the earlier runs (the message names
    ///         the nearest state within), or if the predicted solid fraction is not that of a dense
    ///         flow (0.4 to 0.74)
    StatePrediction at(const RequestedState& requested) const;
    /// Predicts all observables along a curve: the state `requested`, with the varied quantity set
    /// to each of its values.
    /// @throws InputError if fewer than two states of the curve can be predicted, or if a predicted
    ///         solid fraction is not that of a dense flow (0.4 to 0.74)
    PredictionCurve along(RequestedState requested, const VariedQuantity& varied) const;

    /// Returns the closures of Badetti et al. (2018) for a wet run, from the observables of the run
    /// and the stress ratio that the emulator predicts for dry grains with equal friction
    /// coefficient, inertial number and stiffness number. Empty if the run is dry, if the earlier
    /// runs do not support this prediction, if the damping of the contacts is not the default
    /// damping, or if an effect of the run also changes dry flow.
    std::optional<closures::ClosureValues> closures_of(const dem::RunResult& run) const;

    /// Returns a requested state, of grains of stiffness_number(), in the coordinates of the
    /// emulator.
    /// @throws InputError if the state is wet but no earlier run is wet, or dry but no run is dry
    FlowState state_of(RequestedState requested) const;
    /// Returns why each state cannot be predicted (`supports`), such as "friction 0.9 is above
    /// 0.6"; empty if it can.
    std::vector<std::string> why_unsupported(const std::vector<FlowState>& states) const {
        return known_.why_unsupported(states);
    }

    /// Returns the parameters of the run that simulates a state that cannot be predicted.
    /// @throws InputError if the state cannot be simulated
    dem::RunParameters run_for(const RequestedState& requested) const;

  private:
    std::vector<EmulatedObservable> observables_at(const FlowState& state) const;
    std::string unsupported(const RequestedState& requested, const FlowState& state,
                            const std::string& why) const;

    Fidelity fidelity_;
    double stiffness_number_;
    Emulator emulator_;
    KnownRange known_;
};

}  // namespace pendular
