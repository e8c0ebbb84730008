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

/// Number of simulation runs that a planner of runs (RunPlanner) carried out for one reason.
struct SimulatedRuns {
    /// Number of simulation runs that the planner carried out for the reason `why`.
    std::size_t runs = 0;
    /// Reason for the simulation runs, such as "to confirm the optimum".
    std::string why;
};

/// Planner of the simulation runs of a calibration (fit of the friction coefficient to readings).
/// The planner repeatedly chooses the runs that most reduce the errors of the predicted readings,
/// carries out the runs and trains the emulator on the runs. In turn, the planner requests
/// - if there are no earlier runs, dry runs spread over friction coefficient and inertial number,
/// - runs at the states of steady shear of readings that lie outside the range of the earlier runs,
///   and
/// - runs near the fitted friction coefficient, which check the emulator and reduce the errors of
///   the predictions.
class RunPlanner {
  public:
    /// Trains a first emulator on the earlier runs `known`. If there are no earlier runs and new
    /// runs are allowed (`KnownRuns::may_simulate`), the constructor first simulates dry grains.
    /// @param conditions conditions at which the emulator must predict the study's readings
    /// @param fidelity settings of the simulations
    /// @param seed seed from which the seeds of the runs follow
    /// @param budget time limit of all simulations
    /// @throws std::invalid_argument if none of the earlier runs can serve as a training run, or if
    ///         a condition is wet but the study has no liquid
    /// @throws dem::SimulationError if all of the first dry runs fail
    RunPlanner(const Study& study, const std::vector<Condition>& conditions,
               const Fidelity& fidelity, std::uint64_t seed, Workers workers, KnownRuns known,
               RunBudget budget = {});

    /// Returns the predictor of dry and wet readings. Its emulator is trained on the earlier runs
    /// and on all new runs carried out so far.
    const std::shared_ptr<const EmulatedSimulation>& simulation() const { return simulation_; }

    /// Improves the predictions of readings at a friction coefficient [1] by new simulation runs,
    /// if new runs are allowed. The first call requests runs at states of steady shear outside the
    /// range of the earlier runs. Later calls request runs near `friction`, which check and improve
    /// the emulator.
    /// @param conditions conditions truly imposed on the grains, dry and wet
    /// @param excess variance that the noise of the runs causes in the last fit, divided by the
    ///        largest acceptable variance [1] (`Enlargement::excess`); later calls aim to reduce
    ///        the variances of the predictions by the factor `excess`
    /// @throws dem::SimulationError if a condition is wet, no training run is wet, and all of the
    ///         first wet runs fail
    void improve(double friction, const std::vector<EffectiveCondition>& conditions, double excess);
    /// Improves the predictions of wet readings at a friction coefficient [1] by new simulation
    /// runs, if new runs are allowed. Each call first requests runs at states of steady shear
    /// outside the range of the earlier runs. Then the first call checks the emulator with few
    /// runs. Later calls request as many runs as reduce the variances of the predictions by a
    /// factor of 1 + `turns`, but at most 16 runs.
    /// @param conditions wet conditions truly imposed on the grains
    /// @param turns factor by which later calls reduce the variances, minus 1 [1]
    /// @throws dem::SimulationError if no training run is wet and all of the first wet runs fail
    void improve_wet(double friction, const std::vector<EffectiveCondition>& conditions, int turns);

    /// Whether new runs confirm the emulator. The new runs of the last call of `improve`, and of
    /// all later calls of `improve_wet`, must agree at 1 % significance with the emulator's
    /// predictions before the training on the runs. The result is false after the first call of
    /// `improve`, which checks nothing, and if none of the finished new runs was usable. The result
    /// is true if new runs are not allowed.
    bool confirmed() const { return confirmed_ || !orders_more_; }
    /// Whether the planner may request new runs (`KnownRuns::may_simulate`).
    bool may_simulate() const { return orders_more_; }
    /// Whether the time limit is reached: none of the simulation runs that the planner chose last
    /// ended in time.
    bool exhausted() const { return exhausted_; }
    /// Returns the numbers of simulation runs that the planner has carried out so far, with an
    /// entry for each reason.
    const std::vector<SimulatedRuns>& simulated() const { return simulated_; }
    /// Returns messages for the user about runs that the emulator is not trained on, such as failed
    /// runs, and about new runs that disagreed with the emulator's predictions.
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    /// Three states of steady shear at which simulation runs may be requested to predict one
    /// condition: at a given friction coefficient (`at_friction`), at a lower friction coefficient
    /// (`below`) and at a higher friction coefficient (`above`).
    struct Candidate {
        FlowState at_friction, below, above;
    };
    /// Returns the states of steady shear at which runs may be requested for the dry conditions
    /// (`wet` is false) or for the wet conditions, at the friction coefficient `friction` [1] and
    /// at a lower and a higher friction coefficient. If effects on grains act at the conditions,
    /// conditions whose states at `friction` are nearly equal count once.
    std::vector<Candidate> candidates(double friction,
                                      const std::vector<EffectiveCondition>& conditions,
                                      bool wet) const;
    /// Returns the dry states of the first runs of a planner without earlier runs: a grid of
    /// friction coefficients and inertial numbers.
    std::vector<FlowState> first_dry_design() const;
    /// Returns the states of steady shear of the first wet runs. The states cover the study's wet
    /// conditions. The friction coefficients of the states are spread around `friction` [1]. The
    /// bridge volumes are spread around the volumes that follow from the liquid contents of the
    /// conditions.
    std::vector<FlowState> first_wet_design(double friction) const;
    /// Simulates the states of first_wet_design() and trains the emulator on the runs. The function
    /// does nothing if a training run is wet already or if new runs are not allowed.
    /// @throws dem::SimulationError if all of the first wet runs fail
    void begin_wet(double friction);
    /// Carries out the work of the function `improve` for the dry conditions alone (`wet` is false)
    /// or for the wet conditions alone (`wet` is true).
    void learn(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
               double excess);
    /// Finds the states for the dry (`wet` is false) or wet conditions that lie outside the range
    /// of the earlier runs, at the friction coefficient `friction` [1]. Requests the runs that most
    /// improve the predictions at these states. Each run is at one of these states, or at the lower
    /// or higher friction coefficient that `candidates` returns for the state.
    void order_beyond(double friction, const std::vector<EffectiveCondition>& conditions, bool wet);
    /// Requests runs near the friction coefficient `friction` [1], the optimum of a fit, for the
    /// dry conditions (`wet` is false) or the wet conditions, and tests whether the runs agree with
    /// the emulator. If the runs disagree, confirmed() becomes false.
    /// @param excess factor by which the weighted variances of the predictions are to decrease [1]
    void confirm(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
                 double excess);
    /// Chooses the states among `from` at which runs most reduce the variances of the stress ratios
    /// and solid fractions predicted at `targets` (pendular::most_informative). The function
    /// chooses states until the variances have decreased by a factor `excess` [1].
    std::vector<FlowState> most_informative(const std::vector<FlowState>& targets,
                                            const std::vector<FlowState>& from,
                                            double excess) const;
    /// Returns the reason why none of the first simulation runs succeeded, for the message of an
    /// exception. The reason is the last of notes(). If there are no notes, the reason is that the
    /// time for simulations ended before the first run ended.
    std::string last_note() const;
    /// Returns the parameters of a new simulation run at each of `states`, in the order of
    /// `states`. The seeds make each new run differ from all runs on which the emulator is trained.
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states);
    /// Simulates `runs`, adds the number of finished runs to the entry `why` of simulated(), and
    /// returns the results on which the emulator can be trained.
    std::vector<dem::RunResult> simulated(const std::vector<dem::RunParameters>& runs,
                                          const std::string& why);
    /// Carries out one run at each of the first n of `states` and trains the emulator on the runs.
    /// The number n follows from the time budget (RunBudget::batch). The function adds the number
    /// of finished runs to the entry `why` of simulated().
    /// @return p value of the agreement of the runs with the emulator before the training
    ///         (`agreement`); empty if no run had a usable result, or the budget allowed no run
    std::optional<double> simulate_at(const std::vector<FlowState>& states, const std::string& why);
    /// Adds the number `runs` to the entry of simulated() with the reason `why`.
    void count_runs(std::size_t runs, const std::string& why);
    /// Replaces the predictor that simulation() returns by a predictor that uses `emulator`.
    void use(Emulator emulator);

    Study study_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    FreshSeeds seeds_;
    Workers workers_;
    RunBudget budget_;
    bool orders_more_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    /// Lowest inertial number of the study's readings [1].
    double slowest_;
    /// Inertial numbers at which the planner requests simulations of dry grains [1].
    std::vector<double> inertial_numbers_;
    /// Whether the planner began without earlier runs and the predictions of slow readings are
    /// extrapolated in the inertial number. A prediction is extrapolated if the inertial number of
    /// the reading is more than 5 % below `Fidelity::lowest_inertial_number`.
    bool extrapolates_ = false;
    std::vector<WetSetting> wet_settings_;
    std::vector<std::string> notes_;
    std::vector<SimulatedRuns> simulated_;
    /// Simulation runs that the planner has carried out so far.
    std::vector<dem::RunResult> made_;
    bool exhausted_ = false;
    /// Number of calls of the function `improve` so far.
    int rounds_ = 0;
    bool began_wet_ = false;
    bool confirmed_ = false;
};

}  // namespace pendular
