#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calib/emulator/emulated_state.h"
#include "calib/emulator/known_range.h"
#include "sim/runs/store/run_store.h"
#include "workflow/requested_state.h"

namespace pendular {

/// Prediction of the known runs at one state.
struct StatePrediction {
    FlowState state;
    std::vector<EmulatedObservable> observables;
    double stiffness_number = 1000;  ///< stiffness number for which the solid fraction holds [1]
    std::string beyond;              ///< `Emulator::beyond` of the state
    std::size_t runs = 0;            ///< number of training runs
};

/// The one quantity of a state that a curve varies, from one value to another.
struct VariedQuantity {
    std::string name;  ///< "friction", "inertial_number", "reduced_pressure", "bridge_volume" or
                       ///< "liquid_content"
    double from = 0, to = 0;
    int points = 60;
    bool logarithmic = false;  ///< even steps of the logarithm

    /// Parses "reduced-pressure=0.5:10".
    /// @throws InputError for any other text
    static VariedQuantity parsed(const std::string& text, int points);
    double at(int k) const;
    void set(RequestedState& requested, double value) const;
};

/// Predictions along a line of states, as far as the known runs support them.
struct PredictionCurve {
    std::string variable;  ///< as in `VariedQuantity`
    std::vector<double> at;
    std::vector<FlowState> states;
    std::vector<std::vector<EmulatedObservable>> observables;  ///< observables of each state
    double stiffness_number = 1000;
    int left_out = 0;          ///< number of states that the known runs do not support
    std::string why_left_out;  ///< reason for the first of them
};

/// Predicts steady shear at any state from the runs of the atlas and of a store, without a study
/// and without a new run.
class StatePredictor {
  public:
    /// @param stiffness_number to which solid fractions are corrected [1], 100 or more
    /// @throws InputError where atlas and store have too few runs to train an emulator, and
    ///         whatever `check_stiffness_number` throws
    StatePredictor(const Fidelity& fidelity, const RunStore* store, double stiffness_number);
    StatePredictor(const StatePredictor&) = delete;
    StatePredictor& operator=(const StatePredictor&) = delete;

    /// Checks that solid fractions can be corrected to a stiffness number [1].
    /// @throws InputError where they cannot
    static void check_stiffness_number(double stiffness_number);

    const Emulator& emulator() const { return emulator_; }
    double stiffness_number() const { return stiffness_number_; }

    /// Whether the known runs support a prediction at a state.
    bool supports(const RequestedState& requested) const;
    /// @throws InputError where the known runs do not support the state, with the nearest one that
    ///         they support
    StatePrediction at(const RequestedState& requested) const;
    /// @throws InputError where fewer than two states are supported
    PredictionCurve along(RequestedState requested, const VariedQuantity& varied) const;

    /// Run that simulates a state that the known runs do not support.
    /// @throws InputError where it cannot be simulated
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
