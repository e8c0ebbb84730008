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

/// Runs that were ordered, with the reason.
struct Order {
    std::size_t runs = 0;
    std::string why;
};

/// Decides which runs would reduce the errors of a study's predictions most, has them carried out
/// and makes a better predictor from them, repeatedly. It requests two kinds of runs: those outside
/// the known range, where an emulator must not extrapolate, and those near the optimum of a fit,
/// which check the emulator; among the latter it takes those that lower the variance of the
/// predictions most. Without known runs it begins with a design that fills the space of the study's
/// conditions.
class RunPlanner {
  public:
    /// `conditions`: of the study's readings, which the predictions are for. Without known runs the
    /// first design is carried out at once.
    /// @throws std::invalid_argument where no known run can teach; dem::SimulationError where no
    ///         run of the first design does
    RunPlanner(const Study& study, const std::vector<Condition>& conditions,
               const Fidelity& fidelity, std::uint64_t seed, Workers workers, KnownRuns known);

    /// The predictor from all runs known by now.
    const std::shared_ptr<const EmulatedSimulation>& simulation() const { return simulation_; }

    /// Sharpens predictions at a friction for some conditions, those truly imposed: the first time
    /// it orders what lies beyond the known runs, later what confirms. `excess` is the factor by
    /// which the variance that simulation causes in a fit is too large.
    void improve(double friction, const std::vector<EffectiveCondition>& conditions, double excess);
    /// Improves the wet predictions alone, with `turns` times as many runs for each wet setting.
    void improve_wet(double friction, const std::vector<EffectiveCondition>& conditions, int turns);

    /// Whether the last new runs agreed with the emulator's predictions for them, at the 1 % level.
    bool confirmed() const { return confirmed_ || !orders_more_; }
    /// Whether new runs may be ordered.
    bool orders_more() const { return orders_more_; }
    /// All orders so far.
    const std::vector<Order>& orders() const { return orders_; }
    /// Lines the user should read, such as runs left out.
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    /// States of the readings at a friction and, in the same order, on either side of it.
    struct Candidates {
        std::vector<FlowState> at_friction, below, above;
    };
    Candidates candidates(double friction, const std::vector<EffectiveCondition>& conditions,
                          bool wet) const;
    std::vector<FlowState> first_dry_design() const;
    std::vector<FlowState> first_wet_design(double friction) const;
    void begin_wet(double friction);
    void learn(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
               double excess);
    void order_beyond(double friction, const std::vector<EffectiveCondition>& conditions, bool wet);
    void confirm(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
                 double excess);
    /// States at which a run reduces the variance at the targets most, one after the other, some
    /// repeatedly, until the variance has fallen by a factor `excess`.
    std::vector<FlowState> most_informative(const std::vector<FlowState>& targets,
                                            const std::vector<FlowState>& from,
                                            double excess) const;
    /// Carries out runs at these states. @return those that can serve as training runs
    std::vector<dem::RunResult> simulate_states(const std::vector<FlowState>& states,
                                                const std::string& why);
    /// Carries runs out at these states and learns from them.
    /// @return probability of a difference at least as large between these runs and the emulator's
    /// predictions
    double order(const std::vector<FlowState>& states, const std::string& why);
    void add_order(std::size_t runs, const std::string& why);
    void use(Emulator emulator);

    Study study_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    Workers workers_;
    bool orders_more_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    double slowest_;                        ///< inertial number of the readings
    std::vector<double> inertial_numbers_;  ///< at which dry runs are ordered
    bool extrapolates_ = false;  ///< whether readings are slower than all runs there will be
    std::vector<WetSetting> wet_settings_;
    std::vector<std::string> notes_;
    std::vector<Order> orders_;
    /// Number of the next run, which gives it a seed of its own.
    std::uint64_t ordered_ = std::uint64_t{1} << 32;
    int rounds_ = 0;
    bool began_wet_ = false;
    bool confirmed_ = false;
};

}  // namespace pendular
