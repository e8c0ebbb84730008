#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "calib/model/emulated_simulation.h"
#include "calib/model/fresh_runs.h"
#include "calib/model/run_budget.h"
#include "calib/model/run_design.h"
#include "data/study/study.h"
#include "sim/runs/ensemble.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Number of simulation runs that a `RunPlanner` requested for one reason.
struct Order {
    std::size_t runs = 0;  ///< number of runs
    std::string why;       ///< reason, as in "to confirm the optimum"
};

/// Planner of simulations: it decides repeatedly which runs would reduce the errors of a study's
/// predictions most, carries them out and trains a better predictor on them. It requests two kinds
/// of runs: runs outside the known range (flow states that the earlier runs enclose), where an
/// emulator must not extrapolate, and runs near the optimum of a fit, which check the emulator and
/// are chosen to reduce the variance of the predictions most. Without earlier runs it begins with
/// runs spread over the frictions and inertial numbers of the study.
class RunPlanner {
  public:
    /// Makes a first predictor from the earlier runs. Without earlier runs it simulates dry runs
    /// spread over friction and inertial number at once, if runs may be requested
    /// (`KnownRuns::orders_more`).
    /// @param conditions conditions of the study's readings, which are to be predicted
    /// @param budget time limit of all runs except these first runs
    /// @throws std::invalid_argument where no earlier run can serve as a training run, or
    ///         conditions are wet but the study has no liquid
    /// @throws dem::SimulationError where none of these first dry runs succeeds
    RunPlanner(const Study& study, const std::vector<Condition>& conditions,
               const Fidelity& fidelity, std::uint64_t seed, Workers workers, KnownRuns known,
               RunBudget budget = {});

    /// Predictor of dry and wet readings, trained on all runs known so far.
    const std::shared_ptr<const EmulatedSimulation>& simulation() const { return simulation_; }

    /// Improves the predictions at a friction [1] for truly imposed `conditions` by new runs, if
    /// runs may be requested. The first call requests runs at states outside the range of the known
    /// runs, later calls request runs near `friction` that check and improve the emulator.
    /// @param excess variance that the noise of the runs causes in a fit, over the largest
    ///        acceptable variance [1]
    /// @throws dem::SimulationError where wet runs are needed, none is known and none of the first
    ///         succeeds
    void improve(double friction, const std::vector<EffectiveCondition>& conditions, double excess);
    /// Improves the predictions at a friction [1] for wet `conditions` by new runs, if runs may be
    /// requested. The first call checks the emulator with few runs; later calls request as many as
    /// reduce the variance of the predictions by a factor 1 + `turns`, but at most 16. All calls
    /// first request runs at states outside the range of the earlier runs.
    /// @throws dem::SimulationError where no wet run is known and none of the first succeeds
    void improve_wet(double friction, const std::vector<EffectiveCondition>& conditions, int turns);

    /// Whether the new runs of the last call of `improve`, and of later calls of `improve_wet`,
    /// agreed with the emulator's predictions for them, at the 1 % level. False after the first
    /// call of `improve`, which checks nothing; always true where no new runs may be requested.
    bool confirmed() const { return confirmed_ || !orders_more_; }
    /// Whether the planner may request new runs (`KnownRuns::orders_more`).
    bool orders_more() const { return orders_more_; }
    /// Whether the last runs that the planner chose were not made, since none of them would have
    /// ended within the budget.
    bool exhausted() const { return exhausted_; }
    /// Numbers of runs requested so far, one entry for each reason.
    const std::vector<Order>& orders() const { return orders_; }
    /// Notes for the user: on runs that are not used as training runs, and on new runs that
    /// differed from the emulator's predictions.
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    /// Flow states at which runs may be requested: at a friction and, in the same order, at a lower
    /// and a higher friction.
    struct Candidates {
        std::vector<FlowState> at_friction, below, above;
    };
    /// Flow states at which runs may be requested for the dry (`wet` false) or the wet conditions,
    /// at `friction` [1] and on either side of it.
    Candidates candidates(double friction, const std::vector<EffectiveCondition>& conditions,
                          bool wet) const;
    /// Dry flow states of the runs that a planner without earlier runs simulates first, on a grid
    /// of friction and inertial number.
    std::vector<FlowState> first_dry_design() const;
    /// Wet flow states of the runs to simulate where no wet run is known: they cover the study's
    /// wet conditions, spread over friction about `friction` [1] and over bridge volume.
    std::vector<FlowState> first_wet_design(double friction) const;
    /// Simulates the states of first_wet_design() if no training run is wet yet and runs may be
    /// requested, and trains the emulator on them.
    /// @throws dem::SimulationError where none of these runs succeeds
    void begin_wet(double friction);
    /// Does the work of `improve` for the dry (`wet` false) or the wet conditions alone.
    void learn(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
               double excess);
    /// Requests runs for those states of the dry (`wet` false) or the wet conditions at `friction`
    /// [1] that lie outside the range of the earlier runs.
    void order_beyond(double friction, const std::vector<EffectiveCondition>& conditions, bool wet);
    /// Requests runs near `friction` [1], the optimum of a fit, for the dry (`wet` false) or the
    /// wet conditions and tests whether they agree with the emulator; where they do not,
    /// confirmed() becomes false.
    /// @param excess factor by which the variance of the predictions is to decrease
    void confirm(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
                 double excess);
    /// States among `from` at which runs reduce the variance of the stress ratios and solid
    /// fractions predicted at `targets` most, until this variance has decreased by a factor
    /// `excess` (pendular::most_informative).
    std::vector<FlowState> most_informative(const std::vector<FlowState>& targets,
                                            const std::vector<FlowState>& from,
                                            double excess) const;
    /// Parameters of runs at these states with seeds that no earlier run has.
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states);
    /// Simulates runs, records them under the reason `why` and returns those that can serve as
    /// training runs.
    std::vector<dem::RunResult> simulated(const std::vector<dem::RunParameters>& runs,
                                          const std::string& why);
    /// Carries out those runs at these states that the budget allows, records them under the reason
    /// `why` and trains the emulator on them.
    /// @return p-value of the agreement of these runs with the earlier emulator (`agreement`); 0
    ///         where no run succeeded, 1 where the budget allowed none
    double order(const std::vector<FlowState>& states, const std::string& why);
    /// Adds a number of runs to the entry of orders() with the reason `why`.
    void add_order(std::size_t runs, const std::string& why);
    /// Replaces the predictor simulation() by one that uses this emulator.
    void use(Emulator emulator);

    Study study_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    FreshSeeds seeds_;
    Workers workers_;
    RunBudget budget_;
    bool orders_more_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    double slowest_;  ///< lowest inertial number of the readings [1]
    /// Inertial numbers at which dry runs are requested [1].
    std::vector<double> inertial_numbers_;
    /// Whether a reading's inertial number is below that of all runs (by more than 5 %), in a
    /// calibration that began without earlier runs.
    bool extrapolates_ = false;
    std::vector<WetSetting> wet_settings_;
    std::vector<std::string> notes_;
    std::vector<Order> orders_;
    std::vector<dem::RunResult> made_;  ///< runs carried out so far
    bool exhausted_ = false;
    int rounds_ = 0;  ///< number of calls of `improve`
    bool began_wet_ = false;
    bool confirmed_ = false;
};

}  // namespace pendular
