#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "calib/model/emulated_simulation.h"
#include "calib/model/run_design.h"
#include "data/study/study.h"
#include "sim/runs/ensemble.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Simulation runs that the planner requested for one reason.
struct Order {
    std::size_t runs = 0;  ///< number of runs
    std::string why;       ///< reason, as in "to confirm the optimum"
};

/// Planner of simulations: it decides repeatedly which runs would reduce the errors of a study's
/// predictions most, carries them out and trains a better predictor on them. It requests two kinds
/// of runs: runs outside the known range, where an emulator must not extrapolate, and runs near the
/// optimum of a fit, which check the emulator and are chosen to reduce the variance of the
/// predictions most. Without known runs it begins with a design that fills the space of the study's
/// conditions.
class RunPlanner {
  public:
    /// Trains a first predictor on the known runs. Without known runs it simulates a first dry
    /// design at once, if runs may be requested.
    /// @param conditions conditions of the study's readings, which are to be predicted
    /// @throws std::invalid_argument where no known run can serve as a training run
    /// @throws dem::SimulationError where no run of the first design succeeds
    RunPlanner(const Study& study, const std::vector<Condition>& conditions,
               const Fidelity& fidelity, std::uint64_t seed, Workers workers, KnownRuns known);

    /// Predictor trained on all runs known so far.
    const std::shared_ptr<const EmulatedSimulation>& simulation() const { return simulation_; }

    /// Improves the predictions at a friction for some truly imposed conditions. The first call
    /// requests runs at states outside the known range, later calls request runs near the optimum
    /// that check and improve the emulator.
    /// @param excess factor by which the variance that simulation causes in a fit is too large
    /// @throws dem::SimulationError where no run of the first wet design succeeds
    void improve(double friction, const std::vector<EffectiveCondition>& conditions, double excess);
    /// Improves the predictions of wet conditions alone. The first call checks the emulator with
    /// few runs; later calls request enough to reduce the variance of the predictions by a factor
    /// 1 + `turns`, up to a maximum number of runs.
    /// @throws dem::SimulationError where no run of the first wet design succeeds
    void improve_wet(double friction, const std::vector<EffectiveCondition>& conditions, int turns);

    /// Whether the last new runs agreed with the emulator's predictions for them, at the 1 % level;
    /// also true where no new runs may be requested.
    bool confirmed() const { return confirmed_ || !orders_more_; }
    /// Whether the planner may request new runs.
    bool orders_more() const { return orders_more_; }
    /// Runs requested so far, by reason.
    const std::vector<Order>& orders() const { return orders_; }
    /// Notes for the user, such as on runs that are not used.
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    /// States at which runs may be requested: at a friction and, in the same order, at a lower and
    /// a higher friction.
    struct Candidates {
        std::vector<FlowState> at_friction, below, above;
    };
    /// States of the dry or of the wet conditions at which runs may be requested.
    Candidates candidates(double friction, const std::vector<EffectiveCondition>& conditions,
                          bool wet) const;
    /// Dry states that fill the space of friction and inertial number.
    std::vector<FlowState> first_dry_design() const;
    /// Wet states that cover the wet conditions, spread over friction and bridge volume.
    std::vector<FlowState> first_wet_design(double friction) const;
    /// Simulates the first wet design where no run is wet yet.
    void begin_wet(double friction);
    /// Requests runs for the dry or the wet conditions, as `improve` does.
    void learn(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
               double excess);
    /// Requests runs for the states that lie outside the range of the known runs.
    void order_beyond(double friction, const std::vector<EffectiveCondition>& conditions, bool wet);
    /// Requests runs near the optimum and tests whether they agree with the emulator.
    void confirm(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
                 double excess);
    /// States among `from` at which runs reduce the variance of the predictions at `targets` most.
    /// They are chosen one after the other, some repeatedly, until the variance has decreased by a
    /// factor `excess`.
    std::vector<FlowState> most_informative(const std::vector<FlowState>& targets,
                                            const std::vector<FlowState>& from,
                                            double excess) const;
    /// Carries out runs at these states and returns those that can serve as training runs.
    std::vector<dem::RunResult> simulate_states(const std::vector<FlowState>& states,
                                                const std::string& why);
    /// Carries out runs at these states and trains the emulator on them.
    /// @return probability (p-value) of a difference between these runs and the earlier emulator's
    ///         predictions at least as large as observed; 0 where no run succeeded
    double order(const std::vector<FlowState>& states, const std::string& why);
    /// Adds runs to those requested for a reason.
    void add_order(std::size_t runs, const std::string& why);
    /// Makes the predictor use an emulator.
    void use(Emulator emulator);

    Study study_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    Workers workers_;
    bool orders_more_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    double slowest_;                        ///< lowest inertial number of the readings [1]
    std::vector<double> inertial_numbers_;  ///< inertial numbers of the requested dry runs [1]
    /// Whether readings are slower than all runs, in a calibration that began without known runs.
    bool extrapolates_ = false;
    std::vector<WetSetting> wet_settings_;
    std::vector<std::string> notes_;
    std::vector<Order> orders_;
    /// Number of the next run, from which the seed of the run follows.
    std::uint64_t ordered_ = std::uint64_t{1} << 32;
    int rounds_ = 0;  ///< number of calls of `improve`
    bool began_wet_ = false;
    bool confirmed_ = false;
};

}  // namespace pendular
