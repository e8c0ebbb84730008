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
#include "sim/runs/run_settings.h"

namespace pendular {

/// Number of runs that a RunPlanner carried out for one reason.
struct SimulatedRuns {
    std::size_t runs = 0;
    std::string why;  ///< reason, such as "to confirm the optimum"
};

/// Planner of the simulation runs of a calibration. It repeatedly chooses the runs that most reduce
/// the errors of the predicted readings, carries out the runs and trains the emulator on them. In
/// turn, the planner requests
/// - if there are no earlier runs, dry runs spread over friction coefficient and inertial number,
/// - runs at the states of readings outside the range of the earlier runs, and
/// - runs near the fitted friction coefficient, which check and improve the emulator.
class RunPlanner {
  public:
    /// Trains a first emulator on the earlier runs `known`. If there are none and new runs are
    /// allowed (`KnownRuns::may_simulate`), first simulates dry grains.
    /// @param conditions conditions at which the emulator must predict the study's readings
    /// @param seed seed from which the seeds of the runs follow
    /// @throws std::invalid_argument if none of the earlier runs can serve as a training run, or if
    ///         a condition is wet but the study has no liquid
    /// @throws dem::SimulationError if all of the first dry runs fail
    RunPlanner(const Study& study, const std::vector<Condition>& conditions,
               const Fidelity& fidelity, std::uint64_t seed, Workers workers, KnownRuns known,
               RunBudget budget = {});

    /// Returns the predictor whose emulator is trained on the earlier runs and all new runs so far.
    const std::shared_ptr<const EmulatedSimulation>& simulation() const { return simulation_; }

    /// Improves the predictions of readings at a friction coefficient [1] by new runs, if allowed.
    /// The first call requests runs at states outside the range of the earlier runs, later calls
    /// runs near `friction`, which check and improve the emulator.
    /// @param conditions conditions truly imposed on the grains, dry and wet
    /// @param excess factor [1] by which later calls aim to reduce the variances of the predictions
    ///        (`Enlargement::excess` of the last fit)
    /// @throws dem::SimulationError if a condition is wet, no training run is wet, and all of the
    ///         first wet runs fail
    void improve(double friction, const std::vector<EffectiveCondition>& conditions, double excess);
    /// Improves the predictions of wet readings at a friction coefficient [1] by new runs, if
    /// allowed. Each call first requests runs at states outside the range of the earlier runs. Then
    /// the first call checks the emulator with few runs. Each later call requests as many runs as
    /// halve the variances of the predictions, but at most 16.
    /// @param conditions wet conditions truly imposed on the grains
    /// @throws dem::SimulationError if no training run is wet and all of the first wet runs fail
    void improve_wet(double friction, const std::vector<EffectiveCondition>& conditions);

    /// Whether new runs confirm the emulator: those of the last call of `improve`, and of all later
    /// calls of `improve_wet`, agree at 1 % significance with the predictions before the training
    /// on them. False after the first call of `improve`, which checks nothing, and if no finished
    /// run was usable; true if new runs are not allowed.
    bool confirmed() const { return confirmed_ || !orders_more_; }
    /// Whether the planner may request new runs (`KnownRuns::may_simulate`).
    bool may_simulate() const { return orders_more_; }
    /// Whether the time limit is reached: none of the runs chosen last ended in time.
    bool exhausted() const { return exhausted_; }
    /// Returns the numbers of runs carried out so far, with an entry for each reason.
    const std::vector<SimulatedRuns>& simulated() const { return simulated_; }
    /// Returns messages for the user about runs that the emulator is not trained on, such as failed
    /// runs, and about new runs that disagreed with the emulator's predictions.
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    /// States for one condition, at a given, a lower and a higher friction.
    struct Candidate {
        FlowState at_friction, below, above;
    };
    /// Returns the candidates for the dry conditions (`wet` is false) or the wet ones. If effects
    /// on grains act, conditions whose states at `friction` are nearly equal count once.
    std::vector<Candidate> candidates(double friction,
                                      const std::vector<EffectiveCondition>& conditions,
                                      bool wet) const;
    /// Returns a grid of friction coefficients and inertial numbers.
    std::vector<FlowState> first_dry_design() const;
    /// Returns states that cover the study's wet conditions, with frictions spread around
    /// `friction` and bridge volumes around those of the liquid contents.
    std::vector<FlowState> first_wet_design(double friction) const;
    /// Simulates first_wet_design(), if no training run is wet yet and new runs are allowed.
    /// @throws dem::SimulationError if all of the runs fail
    void begin_wet(double friction);
    /// Carries out `improve` for the dry or the wet conditions alone.
    void learn(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
               double excess);
    /// Requests the runs that most improve the predictions at those states of the conditions that
    /// lie outside the range of the earlier runs.
    void order_beyond(double friction, const std::vector<EffectiveCondition>& conditions, bool wet);
    /// Requests runs near the optimum `friction`. If they disagree, confirmed() becomes false.
    void confirm(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
                 double excess);
    /// Chooses states among `from`, until the variances at `targets` have decreased by `excess`
    /// [1].
    std::vector<FlowState> most_informative(const std::vector<FlowState>& targets,
                                            const std::vector<FlowState>& from,
                                            double excess) const;
    /// Returns why none of the first runs succeeded, for an exception.
    std::string last_note() const;
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states);
    /// Simulates `runs`, counts them under `why`, and returns the usable results.
    std::vector<dem::RunResult> simulated(const std::vector<dem::RunParameters>& runs,
                                          const std::string& why);
    /// Carries out runs at the first of `states`, as many as RunBudget::batch allows, counts them
    /// under `why` and trains the emulator on them.
    /// @return p value of the `agreement` with the emulator before the training; empty if no run
    ///         had a usable result, or the budget allowed no run
    std::optional<double> simulate_at(const std::vector<FlowState>& states, const std::string& why);
    void count_runs(std::size_t runs, const std::string& why);
    void use(Emulator emulator);

    Study study_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    FreshSeeds seeds_;
    Workers workers_;
    RunBudget budget_;
    bool orders_more_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    double slowest_;                        ///< of the study's readings [1]
    std::vector<double> inertial_numbers_;  ///< of the dry runs to request [1]
    /// Whether there were no earlier runs and a reading is slower than all runs (`extrapolated`).
    bool extrapolates_ = false;
    std::vector<WetSetting> wet_settings_;
    std::vector<std::string> notes_;
    std::vector<SimulatedRuns> simulated_;
    std::vector<dem::RunResult> made_;  ///< runs carried out so far
    bool exhausted_ = false;
    int rounds_ = 0;  ///< calls of `improve` so far
    bool began_wet_ = false;
    bool confirmed_ = false;
};

}  // namespace pendular
