#include "calib/model/run_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "calib/model/fresh_runs.h"
#include "calib/model/informative_runs.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/run_settings.h"

namespace pendular {
namespace {

/// Distance in ln(friction + 0.05) between a friction and the frictions of requested runs on either
/// side of it [1]. Chosen: 0.073 and 0.133 about a friction of 0.1.
constexpr double spread = 0.2;
/// Factor by which runs are to reduce the variance at states without any run so far; so large that
/// the maximum number of runs is requested.
constexpr double unknown = 1e9;

/// Frictions of the first dry design, for studies without earlier runs; spaced about evenly in
/// their logarithm.
constexpr double first_frictions[] = {0.02, 0.07, 0.15, 0.3, 0.6};
/// Where readings are slower than all runs, the first design contains a further, faster inertial
/// number, from which to extrapolate: the lowest inertial number of the runs times this factor, but
/// at most `fastest_extrapolated`, above which flow becomes dilute.
constexpr double extrapolation_factor = 10, fastest_extrapolated = 0.3;
/// Half-widths of the region over which the first wet runs are spread: in ln(friction + 0.05) about
/// the friction of a fit (`fitted_width`) or, before any fit, over the whole range (`whole_width`:
/// 0 to 0.76 about the start of fits, 0.15); and in ln V0 (`volume_width`).
constexpr double fitted_width = 0.4, whole_width = 1.4, volume_width = 0.4;
/// Smallest number of runs of the first wet design. Chosen: two for each of the four coordinates of
/// wet flow.
constexpr std::size_t fewest_wet = 8;

/// Errors of stress ratio and solid fraction that count as equally serious [1].
const Eigen::Vector2d grave(0.01, 0.002);

bool has_grain_effects(const std::vector<EffectiveCondition>& conditions) {
    return std::ranges::any_of(
        conditions, [](const EffectiveCondition& c) { return !c.grain_effects.empty(); });
}

/// Lowest inertial number of the conditions [1].
double slowest(const std::vector<Condition>& conditions) {
    double least = INFINITY;
    for (const Condition& condition : conditions) {
        least = std::min(least, condition.inertial_number);
    }
    return least;
}

}  // namespace

RunPlanner::RunPlanner(const Study& study, const std::vector<Condition>& conditions,
                       const Fidelity& fidelity, std::uint64_t seed, Workers workers,
                       KnownRuns known, RunBudget budget)
    : study_(study),
      fidelity_(fidelity),
      seed_(seed),
      seeds_(seed),
      workers_(std::move(workers)),
      budget_(budget),
      orders_more_(known.may_simulate),
      slowest_(slowest(conditions)),
      inertial_numbers_(inertial_numbers_for(conditions, fidelity.lowest_inertial_number)),
      wet_settings_(wet_settings_for(conditions, study, fidelity.lowest_inertial_number)) {
    // Runs of one stiffness number train the emulator: that of the atlas or, without known runs,
    // that of the planner's own runs.
    double trained_stiffness = emulated::reference_stiffness;
    if (known.runs.empty() && orders_more_) {
        if (extrapolated(conditions, fidelity.lowest_inertial_number)) {
            // Two inertial numbers would not determine the approach to the quasi-static limit.
            extrapolates_ = true;
            inertial_numbers_.push_back(std::min(
                extrapolation_factor * fidelity.lowest_inertial_number, fastest_extrapolated));
        }
        trained_stiffness = fidelity.stiffness_number;
        known.runs = simulated(runs_at(first_dry_design()), "since there was none to predict from");
        if (known.runs.empty()) {
            throw dem::SimulationError("no simulation succeeded: " + last_note());
        }
    }
    use(Emulator(known.runs, std::move(known.hyperparameters), trained_stiffness));
}

void RunPlanner::use(Emulator emulator) {
    simulation_ = std::make_shared<EmulatedSimulation>(study_, fidelity_, std::move(emulator));
}

std::vector<FlowState> RunPlanner::first_dry_design() const {
    std::vector<FlowState> states;
    for (const double inertial_number : inertial_numbers_) {
        for (const double friction : first_frictions) {
            states.push_back({friction, inertial_number});
        }
    }
    return states;
}

std::vector<FlowState> RunPlanner::first_wet_design(double friction) const {
    std::vector<WetSetting> settings = wet_settings_;
    while (settings.size() < fewest_wet) {
        settings.insert(settings.end(), wet_settings_.begin(), wet_settings_.end());
    }
    const double width = rounds_ > 0 ? fitted_width : whole_width;
    const auto places = latin_places(settings, seed_of_run(seed_, 0, SeedDomain::run_places));
    std::vector<FlowState> states;
    for (std::size_t k = 0; k < settings.size(); ++k) {
        const double own = friction_at(width * places[k].first, friction);
        FlowState state{simulation_->allowed(own), settings[k].inertial_number,
                        settings[k].inverse_pressure};
        state.bridge_volume =
            dem::bridge_volume(settings[k].liquid_content, dem::typical_coordination) *
            std::exp(volume_width * places[k].second);
        states.push_back(state);
    }
    return states;
}

void RunPlanner::begin_wet(double friction) {
    const auto wet = [](const dem::RunResult& run) { return run.parameters.wetting.has_value(); };
    if (!orders_more_ || std::ranges::any_of(simulation_->emulator().runs(), wet)) {
        return;
    }
    const auto fresh =
        simulated(runs_at(first_wet_design(friction)), "since there was none with liquid bridges");
    if (fresh.empty()) {
        throw dem::SimulationError("no wet simulation succeeded: " + last_note());
    }
    use(simulation_->emulator().with(fresh));
}

std::vector<RunPlanner::Candidate> RunPlanner::candidates(
    double friction, const std::vector<EffectiveCondition>& conditions, bool wet) const {
    const double below = simulation_->allowed(friction_at(-spread, friction)),
                 above = simulation_->allowed(friction_at(spread, friction));
    std::vector<Candidate> all;
    const auto add = [&](const auto& state_at) {
        all.push_back({state_at(friction), state_at(below), state_at(above)});
    };
    if (has_grain_effects(conditions)) {
        // The amplitude of effects on grains depends on the reading: one candidate for each
        // reading's own state.
        for (EffectiveCondition simulated : conditions) {
            if (simulated.dry() == wet) continue;
            simulated.inertial_number =
                std::max(simulated.inertial_number, fidelity_.lowest_inertial_number);
            const auto state_at = [&](double at) {
                FlowState state = simulation_->flow_state_at(at, simulated);
                state.stiffness_number = 0;  // that of simulations
                return state;
            };
            const FlowState state = state_at(friction);
            if (std::ranges::none_of(
                    all, [&](const auto& other) { return near(other.at_friction, state); })) {
                add(state_at);
            }
        }
    } else if (wet) {
        for (const WetSetting& setting : wet_settings_) {
            add([&](double at) {
                return simulation_->filled({at, setting.inertial_number, setting.inverse_pressure},
                                           setting.liquid_content);
            });
        }
    } else {
        for (const double inertial_number : inertial_numbers_) {
            add([&](double at) { return FlowState{at, inertial_number}; });
        }
    }
    return all;
}

std::vector<FlowState> RunPlanner::most_informative(const std::vector<FlowState>& targets,
                                                    const std::vector<FlowState>& from,
                                                    double excess) const {
    const auto count = static_cast<Eigen::Index>(targets.size());
    return pendular::most_informative(
        simulation_->emulator(), fidelity_,
        {.targets = targets,
         .weights = grave.cwiseInverse().cwiseAbs2().replicate(count, 1),
         .from = from,
         .factor = excess});
}

void RunPlanner::improve(double friction, const std::vector<EffectiveCondition>& conditions,
                         double excess) {
    // The first round only fills gaps. `confirm` withdraws this if new runs disagree with the
    // emulator or none could be made.
    confirmed_ = rounds_ > 0;
    const auto wet = [](const EffectiveCondition& c) { return !c.dry(); };
    if (!std::ranges::all_of(conditions, wet)) {
        learn(friction, conditions, false, excess);
    }
    if (std::ranges::any_of(conditions, wet)) {
        learn(friction, conditions, true, excess);
    }
    ++rounds_;
}

void RunPlanner::improve_wet(double friction, const std::vector<EffectiveCondition>& conditions) {
    begin_wet(friction);
    // States outside the known range come first, regardless of the rounds for the dry readings.
    order_beyond(friction, conditions, true);
    // The first runs only confirm; more are requested where predictions stay too uncertain: a
    // factor of 2 halves the variances.
    confirm(friction, conditions, true, began_wet_ ? 2 : 1);
    began_wet_ = true;
}

void RunPlanner::learn(double friction, const std::vector<EffectiveCondition>& conditions, bool wet,
                       double excess) {
    if (wet) {
        begin_wet(friction);
    }
    if (rounds_ == 0) {
        order_beyond(friction, conditions, wet);
    } else {
        confirm(friction, conditions, wet, excess);
    }
}

void RunPlanner::order_beyond(double friction, const std::vector<EffectiveCondition>& conditions,
                              bool wet) {
    std::vector<FlowState> targets, from;
    std::string why;
    for (const Candidate& each : candidates(friction, conditions, wet)) {
        const std::string text = simulation_->emulator().beyond(each.at_friction);
        if (!text.empty()) {
            why = text;
            targets.push_back(each.at_friction);
            from.insert(from.end(), {each.below, each.at_friction, each.above});
        }
    }
    if (targets.empty() || !orders_more_) {
        return;  // the notes of a calibration name the readings that runs do not support
    }
    // Without runs nearby, the initial error is that of the prior.
    simulate_at(most_informative(targets, from, unknown),
                "since " + why + " of the earlier simulations");
}

void RunPlanner::confirm(double friction, const std::vector<EffectiveCondition>& conditions,
                         bool wet, double excess) {
    if (!orders_more_) {
        return;
    }
    const std::vector<Candidate> all = candidates(friction, conditions, wet);
    std::vector<FlowState> targets, from;
    std::ranges::transform(all, std::back_inserter(targets), &Candidate::at_friction);
    from = targets;
    std::ranges::transform(all, std::back_inserter(from), &Candidate::below);
    std::ranges::transform(all, std::back_inserter(from), &Candidate::above);
    if (has_grain_effects(conditions)) {
        // Where an effect is small, predictions with it rest on runs without it.
        for (const Candidate& each : all) {
            from.push_back(each.at_friction);
            from.back().effects.clear();
        }
    }
    if (extrapolates_ && !wet) {
        targets.push_back({friction, slowest_});
    }
    const std::optional<double> p =
        simulate_at(most_informative(targets, from, excess),
                    wet ? "to confirm the wet readings" : "to confirm the optimum");
    if (!p) {
        confirmed_ = confirmed_ && exhausted_;
    } else if (*p < disagreement) {
        confirmed_ = false;
        notes_.push_back(
            fmt::format("New simulations {} differed from the emulator's predictions (p = {:.2g}); "
                        "the emulator is now trained on them.",
                        wet ? "at the wet readings" : "at the optimum", *p));
    }
}

std::vector<dem::RunResult> RunPlanner::simulated(const std::vector<dem::RunParameters>& runs,
                                                  const std::string& why) {
    const std::vector<dem::RunResult> done = budget_.run(runs, workers_);
    made_.insert(made_.end(), done.begin(), done.end());
    if (!done.empty()) count_runs(done.size(), why);
    return usable_of(done, notes_);
}

std::string RunPlanner::last_note() const {
    return notes_.empty() ? "the time for simulations ended before the first of them"
                          : notes_.back();
}

std::vector<dem::RunParameters> RunPlanner::runs_at(const std::vector<FlowState>& states) {
    return seeds_.runs_at(
        states, study_, fidelity_,
        simulation_ ? simulation_->emulator().runs() : std::vector<dem::RunResult>{});
}

std::optional<double> RunPlanner::simulate_at(const std::vector<FlowState>& states,
                                              const std::string& why) {
    const Emulator& emulator = simulation_->emulator();
    std::vector<dem::RunParameters> runs = runs_at(states);
    runs.resize(budget_.batch(runs, made_.empty() ? emulator.runs() : made_, workers_.threads));
    exhausted_ = runs.empty();
    if (exhausted_) return std::nullopt;
    const std::size_t before = made_.size();
    const std::vector<dem::RunResult> fresh = simulated(runs, why);
    exhausted_ = made_.size() == before;  // the time ended before any of them
    if (fresh.empty()) return std::nullopt;
    const double p = agreement(emulator, fresh);
    use(emulator.with(fresh));
    return p;
}

void RunPlanner::count_runs(std::size_t runs, const std::string& why) {
    const auto same = std::ranges::find(simulated_, why, &SimulatedRuns::why);
    if (same == simulated_.end()) {
        simulated_.push_back({runs, why});
    } else {
        same->runs += runs;
    }
}

}  // namespace pendular
