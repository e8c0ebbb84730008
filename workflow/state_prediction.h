#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calib/emulator/emulated_state.h"
#include "calib/emulator/known_range.h"
#include "sim/closures/closure_values.h"
#include "sim/runs/store/run_store.h"
#include "workflow/requested_state.h"

namespace pendular {

/// Predicted observables at one state of steady shear, by an emulator trained on the runs of atlas
/// and store.
struct StatePrediction {
    FlowState state;
    /// Predicted values of the observables at the state.
    std::vector<EmulatedObservable> observables;
    /// Stiffness number of the grains for which predictions hold [1].
    double stiffness_number = 1000;
    /// Coordinates in which the state lies beyond all training runs, as text (`Emulator::beyond`);
    /// empty: none.
    std::string beyond;
    std::size_t runs = 0;  ///< number of the emulator's training runs
    /// Values of the closures of Badetti et al. (2018) for a wet state, from the predicted values;
    /// empty: dry.
    std::optional<closures::ClosureValues> closures = {};
};

/// Quantity of a state of steady shear that varies along a curve of predictions, with its range.
struct VariedQuantity {
    /// Name of the quantity: "friction", "inertial_number", "reduced_pressure", "bridge_volume" or
    /// "liquid_content".
    std::string name;
    double from = 0, to = 0;   ///< first and last value of the quantity [1]
    int points = 60;           ///< number of values of the quantity
    bool logarithmic = false;  ///< whether the values are evenly spaced in the logarithm

    /// Parses a text such as "reduced-pressure=0.5:10", which gives name, first and last value.
    /// @throws InputError for any other text, a range that does not increase, or fewer than two
    ///         points
    static VariedQuantity parsed(const std::string& text, int points);
    /// Value k of the varied quantity [1], for k from 0 (`from`) to points - 1 (`to`).
    double at(int k) const;
    /// Sets the varied quantity of a requested state to a value [1].
    void set(RequestedState& requested, double value) const;
};

/// Predictions along a curve of states that differ in one quantity. States that the runs of atlas
/// and store do not cover are left out.
struct PredictionCurve {
    std::string variable;           ///< name of the varied quantity, as in `VariedQuantity`
    std::vector<double> at;         ///< value of the varied quantity at each state [1]
    std::vector<FlowState> states;  ///< states that the runs of atlas and store cover
    /// Predicted observables of each state.
    std::vector<std::vector<EmulatedObservable>> observables;
    /// Values of the closures at each state, from the predicted values; empty: dry.
    std::vector<closures::ClosureValues> closures;
    /// Stiffness number of the grains for which predictions hold [1].
    double stiffness_number = 1000;
    int left_out = 0;          ///< number of states that these runs do not cover
    std::string why_left_out;  ///< reason why the first state left out is not covered
};

/// Predicts steady shear at any state from the runs of the atlas (the runs that come with the
/// program) and of a store (the user's file of runs), without a study and without new runs.
class StatePredictor {
  public:
    /// @param store user's file of runs; may be null
    /// @param stiffness_number stiffness number of the grains to predict [1], 100 or more
    /// @throws InputError where atlas and store have too few runs to train an emulator, and
    ///         whatever `check_stiffness_number` throws
    StatePredictor(const Fidelity& fidelity, const RunStore* store, double stiffness_number);
    StatePredictor(const StatePredictor&) = delete;
    StatePredictor& operator=(const StatePredictor&) = delete;

    /// Checks that predicted solid fractions can be corrected to this stiffness number [1].
    /// @throws InputError where the stiffness number is below 100
    static void check_stiffness_number(double stiffness_number);

    const Emulator& emulator() const { return emulator_; }
    double stiffness_number() const { return stiffness_number_; }

    /// Whether the runs of atlas and store cover a requested state: the state is within their
    /// convex hull, and the predicted errors are small enough.
    /// @throws InputError for a wet state where no earlier run is wet, and for a dry state where no
    ///         earlier run is dry
    bool supports(const RequestedState& requested) const;
    /// Predicts all observables at a requested state of steady shear.
    /// @throws InputError where the earlier runs do not support the state, naming the nearest
    ///         supported state, and where the solid fraction would be impossible
    StatePrediction at(const RequestedState& requested) const;
    /// Predicts all observables along a curve of states: `requested`, with the varied quantity set
    /// to each of its values.
    /// @throws InputError where fewer than two states of the curve lie within the range of the
    ///         earlier runs (atlas and store), and where a predicted solid fraction is impossible
    ///         in a dense flow
    PredictionCurve along(RequestedState requested, const VariedQuantity& varied) const;

    /// Values of the closures for the state of a wet run, from what the run measured and the
    /// predicted stress ratio of dry grains at its friction and inertial number. Empty for a dry
    /// run, and where the earlier runs do not allow that prediction or an effect of the run acts on
    /// dry grains too.
    std::optional<closures::ClosureValues> closures_of(const dem::RunResult& run) const;

    /// Parameters of the run to simulate for a requested state that cannot be predicted from the
    /// earlier runs.
    /// @throws InputError where the state cannot be simulated
    dem::RunParameters run_for(const RequestedState& requested) const;

  private:
    /// Requested state for grains of `stiffness_number`.
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
