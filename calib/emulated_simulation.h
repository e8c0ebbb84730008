#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "calib/emulator.h"
#include "calib/run_design.h"
#include "calib/simulation_model.h"
#include "data/study.h"
#include "sim/ensemble.h"
#include "sim/fidelity.h"

namespace pendular {

/// Runs that were ordered, and why.
struct Order {
    std::size_t runs = 0;
    std::string why;
};

/// What an emulated simulation begins with.
struct KnownRuns {
    std::vector<dem::RunResult> runs;
    EmulatorScales scales;    ///< those missing are learned
    bool orders_more = true;  ///< whether runs may be ordered
};

/// The emulator as a model of dry and wet readings. It answers at once from the runs that are
/// known, and orders fresh ones: at conditions beyond all known runs, where it must not guess, and
/// at the optimum of a fit, where they confirm what it said of them. Those are chosen to lower the
/// variance of the predictions most, one after the other.
///
/// A solid fraction is that of rigid beads less what the study's stiffness adds, known from the
/// overlaps. A liquid content is turned into a bridge volume with the emulated coordination.
class EmulatedSimulation : public SimulationModel {
  public:
    /// @throws std::invalid_argument where no known run can teach
    EmulatedSimulation(const Study& study, const std::vector<Condition>& conditions,
                       const Fidelity& fidelity, std::uint64_t seed, Workers workers,
                       KnownRuns known);

    Prediction predict_conditions(const Eigen::VectorXd& parameters,
                                  const std::vector<Condition>& conditions) const override;
    Prediction predict_mean_conditions(const Eigen::VectorXd& parameters,
                                       const std::vector<Condition>& conditions) const override;
    Eigen::VectorXd values_of_conditions(const Eigen::VectorXd& parameters,
                                         const std::vector<Condition>& conditions) const override;
    /// The first time it orders what lies beyond the known runs, later what confirms.
    void improve(const Eigen::VectorXd& parameters, double excess) override;
    void learn_wet(const Eigen::VectorXd& parameters, int turns) override;
    Supported supported() const override;
    /// Whether the last fresh runs agreed with what the emulator said of them before, at 1 %.
    bool confirmed() const override { return confirmed_ || !orders_more_; }

    const std::vector<dem::RunResult>& runs() const override { return emulator_.runs(); }
    const std::vector<std::string>& notes() const override { return notes_; }
    const std::vector<double>& inertial_numbers() const override { return inertial_numbers_; }
    FlowState state_of(double friction, const Condition& condition) const override;
    StructureResponse effective_coordination(double friction,
                                             const Condition& condition) const override;
    StructureResponse capillary_shear_stress(double friction,
                                             const Condition& condition) const override;

    const Emulator& emulator() const { return emulator_; }
    /// Whether it may order runs.
    bool orders_more() const { return orders_more_; }
    /// All that was ordered so far.
    const std::vector<Order>& orders() const { return orders_; }

    /// Runs that can serve a study: of its bridge force, of no effects but those it lists, of as
    /// many beads as the fidelity has or 1000, and of a Poisson ratio within 0.1 of its beads',
    /// which changes the ratio of tangential to normal stiffness by less than a tenth.
    static std::vector<dem::RunResult> serving(const Study& study, const Fidelity& fidelity,
                                               const std::vector<dem::RunResult>& runs);

  private:
    /// What the errors of predictions are made of.
    struct Errors;
    Prediction predict_states(const std::vector<FlowState>& states,
                              const std::vector<Condition>& conditions, Errors* errors) const;
    /// Of the shift of the solid fraction at the reference stiffness, the part that the beads of a
    /// reading do not show.
    double stiffness_left(const Condition& condition) const;
    std::vector<FlowState> states_of(double friction,
                                     const std::vector<Condition>& conditions) const;
    bool has_grain_effects() const;
    StructureResponse at_constant_content(StructureResponse response, const FlowState& state) const;
    FlowState wet_state(double friction, const WetSetting& setting) const;
    /// A wet state with the bridge volume that this liquid content makes.
    FlowState filled(FlowState state, double liquid_content) const;

    /// States of the readings at a friction and, in the same order, on either side of it.
    struct Candidates {
        std::vector<FlowState> at_friction, below, above;
    };
    Candidates candidates(double friction, bool wet) const;
    void learn(double friction, bool wet, double excess);
    void order_beyond(double friction, bool wet);
    void confirm(double friction, bool wet, double excess);
    /// Those states, one after the other and some more than once, where a run lowers the variance
    /// at the targets most; until it has fallen by a factor `excess`.
    std::vector<FlowState> most_informative(const std::vector<FlowState>& targets,
                                            const std::vector<FlowState>& from,
                                            double excess) const;
    /// Carries runs out at these states and learns from them.
    /// @return probability that they are so far from what the emulator said of them before
    double order(const std::vector<FlowState>& states, const std::string& why);
    void add_order(std::size_t runs, const std::string& why);

    Study study_;
    Fidelity fidelity_;
    std::uint64_t seed_;
    Workers workers_;
    bool orders_more_;
    Emulator emulator_;
    /// States that `filled` found last, which derivatives and covariances ask for again.
    struct Filled {
        double liquid_content;
        FlowState state;
    };
    mutable std::deque<Filled> filled_;
    std::vector<double> inertial_numbers_;
    std::vector<WetSetting> wet_settings_;
    std::vector<std::string> notes_;
    std::vector<Order> orders_;
    /// Number of the next run, which gives it a seed of its own; calibrations by direct simulation
    /// count from 0.
    std::uint64_t ordered_ = std::uint64_t{1} << 32;
    int rounds_ = 0;
    bool began_wet_ = false;
    bool confirmed_ = false;
};

}  // namespace pendular
