#include "calib/model/run_planner.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "calib/model/study_state.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/run_request.h"
#include "sim/runs/seeds.h"

namespace pendular {
namespace {

using dem::Observable;
using emulated::pairs_at;

/// Smallest and largest number of runs that one round requests.
constexpr std::size_t fewest_confirming = 4, most_confirming = 16;
/// Significance level [1]: below this p-value new runs disagree with the emulator's predictions.
constexpr double significance = 0.01;

/// Distance in ln(friction + 0.05) between a friction and the frictions of requested runs on either
/// side of it [1].
constexpr double spread = 0.2;
/// Factor by which runs are to reduce the variance at states where there was no run yet; so large
/// that the maximum number of runs is requested.
constexpr double unknown = 1e9;

/// Frictions of the first dry design, for studies without known runs; spaced about evenly in their
/// logarithm.
constexpr double first_frictions[] = {0.02, 0.07, 0.15, 0.3, 0.6};
/// Where readings are slower than all runs, the first design contains a further, faster inertial
/// number, from which to extrapolate: the lowest inertial number of the runs times this factor, but
/// at most `fastest_extrapolated`, above which flow becomes dilute.
constexpr double extrapolation_factor = 10, fastest_extrapolated = 0.3;
/// Half-widths of the region over which the first wet runs are spread: in ln(friction + 0.05) about
/// the friction of a fit (`fitted_width`) or, before any fit, over the whole range (`whole_width`);
/// and in ln V0 (`volume_width`).
constexpr double fitted_width = 0.4, whole_width = 1.4, volume_width = 0.4;
/// Smallest number of runs of the first wet design.
constexpr std::size_t fewest_wet = 8;

/// Errors of stress ratio and solid fraction that count as equally serious [1].
const Eigen::Vector2d grave(0.01, 0.002);

/// Expected noise of a future run: covariance of its stress ratio and solid fraction [1], scaled
/// from the mean noise of the known runs by the number of grains and the strain.
Eigen::Matrix2d expected_noise(const Emulator& emulator, const Fidelity& fidelity) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const auto& run : emulator.runs()) {
        sum += emulator.noise(run) * run.parameters.grains * run.strain_averaged;
    }
    return sum / (static_cast<double>(emulator.runs().size()) * fidelity.grains * fidelity.strain);
}

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

/// Whether two states of equal friction agree within 5 %, so that one run serves both.
bool near(const FlowState& a, const FlowState& b) {
    constexpr double same = 0.05;
    const auto alike = [&](double x, double y) {
        return std::abs(x - y) <= same * std::max(std::abs(x), std::abs(y));
    };
    return alike(a.inertial_number, b.inertial_number) &&
           alike(a.inverse_pressure, b.inverse_pressure) && alike(a.bridge_volume, b.bridge_volume);
}

std::string describe(const FlowState& state) {
    std::string text = fmt::format("friction {:.3g}, inertial number {:.3g}", state.friction,
                                   state.inertial_number);
    if (!state.dry()) {
        text += fmt::format(", reduced pressure {:.3g}, bridge volume {:.3g} a^3",
                            1 / state.inverse_pressure, state.bridge_volume);
    }
    return text;
}

}  // namespace

RunPlanner::RunPlanner(const Study& study, const std::vector<Condition>& conditions,
                       const Fidelity& fidelity, std::uint64_t seed, Workers workers,
                       KnownRuns known)
    : study_(study),
      fidelity_(fidelity),
      seed_(seed),
      workers_(std::move(workers)),
      orders_more_(known.orders_more),
      slowest_(slowest(conditions)),
      inertial_numbers_(inertial_numbers_for(conditions, fidelity.lowest_inertial_number)),
      wet_settings_(wet_settings_for(conditions, study, fidelity.lowest_inertial_number)) {
    // Structure depends on stiffness: use the stiffness number of the atlas or, without known runs,
    // that of the planner's own runs.
    double structure_stiffness = emulated::reference_stiffness;
    if (known.runs.empty() && orders_more_) {
        if (extrapolated(conditions, fidelity.lowest_inertial_number)) {
            // Two inertial numbers would not determine the approach to the quasi-static limit.
            extrapolates_ = true;
            inertial_numbers_.push_back(std::min(
                extrapolation_factor * fidelity.lowest_inertial_number, fastest_extrapolated));
        }
        structure_stiffness = fidelity.stiffness_number;
        known.runs = simulate_states(first_dry_design(), "since nothing was known");
        if (known.runs.empty()) {
            throw dem::SimulationError("no run succeeded: " + notes_.back());
        }
    }
    use(Emulator(known.runs, std::move(known.hyperparameters), structure_stiffness));
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
    const auto fresh = simulate_states(first_wet_design(friction), "since no wet run was known");
    if (fresh.empty()) {
        throw dem::SimulationError("no wet run succeeded: " + notes_.back());
    }
    use(simulation_->emulator().with(fresh));
}

RunPlanner::Candidates RunPlanner::candidates(double friction,
                                              const std::vector<EffectiveCondition>& conditions,
                                              bool wet) const {
    const auto states_at = [&](double at) {
        std::vector<FlowState> states;
        if (has_grain_effects(conditions)) {
            // The amplitude of effects on grains depends on the reading: one run at each reading's
            // own state.
            for (const EffectiveCondition& condition : conditions) {
                EffectiveCondition simulated = condition;
                simulated.inertial_number =
                    std::max(condition.inertial_number, fidelity_.lowest_inertial_number);
                const FlowState state = simulation_->flow_state_at(at, simulated);
                if (condition.dry() != wet &&
                    std::ranges::none_of(states, [&](const auto& s) { return near(s, state); })) {
                    states.push_back(state);
                }
            }
        } else if (wet) {
            for (const WetSetting& setting : wet_settings_) {
                states.push_back(
                    simulation_->filled({at, setting.inertial_number, setting.inverse_pressure},
                                        setting.liquid_content));
            }
        } else {
            for (const double inertial_number : inertial_numbers_) {
                states.push_back({at, inertial_number});
            }
        }
        return states;
    };
    return {.at_friction = states_at(friction),
            .below = states_at(simulation_->allowed(friction_at(-spread, friction))),
            .above = states_at(simulation_->allowed(friction_at(spread, friction)))};
}

std::vector<FlowState> RunPlanner::most_informative(const std::vector<FlowState>& targets,
                                                    const std::vector<FlowState>& from,
                                                    double excess) const {
    std::vector<FlowState> all = targets;
    all.insert(all.end(), from.begin(), from.end());
    Eigen::MatrixXd covariance = simulation_->emulator().covariance(pairs_at(all));
    const Eigen::Matrix2d noise = expected_noise(simulation_->emulator(), fidelity_);
    const auto wanted = 2 * static_cast<Eigen::Index>(targets.size());
    const Eigen::VectorXd weight =
        grave.cwiseInverse().cwiseAbs2().replicate(static_cast<Eigen::Index>(targets.size()), 1);
    const auto variance = [&] { return weight.dot(covariance.diagonal().head(wanted)); };
    const double enough = variance() / std::max(1.0, excess);
    std::vector<FlowState> chosen;
    while (chosen.size() < most_confirming &&
           (chosen.size() < fewest_confirming || variance() > enough)) {
        // A run at c reduces the covariance by C(., c) [C(c, c) + noise]^-1 C(c, .).
        const auto fall = [&](Eigen::Index c) {
            const auto columns = covariance.middleCols<2>(c);
            const Eigen::Matrix2d inverse = (covariance.block<2, 2>(c, c) + noise).inverse();
            return std::pair(columns, inverse);
        };
        Eigen::Index best = wanted;
        double most = -1;
        for (Eigen::Index c = wanted; c < covariance.rows(); c += 2) {
            const auto [columns, inverse] = fall(c);
            const double gain =
                weight.dot((columns * inverse).cwiseProduct(columns).rowwise().sum().head(wanted));
            if (gain > most) {
                most = gain, best = c;
            }
        }
        const auto [columns, inverse] = fall(best);
        covariance -= Eigen::MatrixXd(columns * inverse * columns.transpose());
        chosen.push_back(all[static_cast<std::size_t>(best / 2)]);
    }
    return chosen;
}

void RunPlanner::improve(double friction, const std::vector<EffectiveCondition>& conditions,
                         double excess) {
    confirmed_ = rounds_ > 0;  // unless fresh runs disagree
    const auto wet = [](const EffectiveCondition& c) { return !c.dry(); };
    if (!std::ranges::all_of(conditions, wet)) {
        learn(friction, conditions, false, excess);
    }
    if (std::ranges::any_of(conditions, wet)) {
        learn(friction, conditions, true, excess);
    }
    ++rounds_;
}

void RunPlanner::improve_wet(double friction, const std::vector<EffectiveCondition>& conditions,
                             int turns) {
    begin_wet(friction);
    // States outside the known range come first, regardless of the rounds for the dry readings.
    order_beyond(friction, conditions, true);
    // The first runs only confirm; more are requested where predictions stay too uncertain.
    confirm(friction, conditions, true, began_wet_ ? 1 + turns : 1);
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
    const Candidates all = candidates(friction, conditions, wet);
    std::vector<FlowState> targets, from;
    std::string why;
    for (std::size_t k = 0; k < all.at_friction.size(); ++k) {
        const std::string text = simulation_->emulator().beyond(all.at_friction[k]);
        if (!text.empty()) {
            why = text;
            targets.push_back(all.at_friction[k]);
            from.insert(from.end(), {all.below[k], all.at_friction[k], all.above[k]});
        }
    }
    if (targets.empty() || !orders_more_) {
        return;  // the notes of a calibration name the readings that runs do not support
    }
    // Without runs nearby, the initial error is that of the prior.
    order(most_informative(targets, from, unknown), "since " + why + " of the known runs");
}

void RunPlanner::confirm(double friction, const std::vector<EffectiveCondition>& conditions,
                         bool wet, double excess) {
    if (!orders_more_) {
        return;
    }
    const Candidates all = candidates(friction, conditions, wet);
    std::vector<FlowState> from = all.at_friction;
    from.insert(from.end(), all.below.begin(), all.below.end());
    from.insert(from.end(), all.above.begin(), all.above.end());
    std::vector<FlowState> targets = all.at_friction;
    if (extrapolates_ && !wet) {
        targets.push_back({friction, slowest_});
    }
    const double p = order(most_informative(targets, from, excess),
                           wet ? "to confirm the wet readings" : "to confirm the optimum");
    if (p < significance) {
        confirmed_ = false;
        notes_.push_back(
            fmt::format("Fresh runs {} differed from the emulator's predictions (p = {:.2g}); the "
                        "emulator is now trained on them.",
                        wet ? "at the wet readings" : "at the optimum", p));
    }
}

std::vector<dem::RunResult> RunPlanner::simulate_states(const std::vector<FlowState>& states,
                                                        const std::string& why) {
    std::set<std::string> known;
    if (simulation_) {
        for (const auto& run : simulation_->emulator().runs()) {
            known.insert(run_description(run.parameters));
        }
    }
    std::vector<dem::RunParameters> wanted;
    for (const FlowState& state : states) {
        dem::RunParameters run = run_at(state, study_, fidelity_);
        // A repetition of a known run would confirm nothing.
        do {
            run.seed = seed_of_run(seed_, ordered_++);
        } while (known.contains(run_description(run)));
        wanted.push_back(run);
    }
    std::vector<dem::RunResult> fresh;
    for (const auto& run : run_all(wanted, workers_)) {
        if (emulated::usable(run)) {
            fresh.push_back(run);
        } else {
            notes_.push_back(fmt::format("a run at {} is not used: it {}",
                                         describe(emulated::flow_state_of(run.parameters)),
                                         !run.failure.empty() ? "failed, " + run.failure
                                         : run.crystallised   ? "crystallised"
                                                              : "was not steady"));
        }
    }
    add_order(wanted.size(), why);
    return fresh;
}

double RunPlanner::order(const std::vector<FlowState>& states, const std::string& why) {
    const std::vector<dem::RunResult> fresh = simulate_states(states, why);
    if (fresh.empty()) {
        return 0;
    }
    std::vector<FlowState> places;
    for (const auto& run : fresh) {
        places.push_back(emulated::flow_state_of(run.parameters));
    }
    const Emulator& emulator = simulation_->emulator();
    const auto queries = pairs_at(places);
    Eigen::VectorXd off = -emulator.mean(queries);
    Eigen::MatrixXd covariance = emulator.covariance(queries);
    for (std::size_t k = 0; k < fresh.size(); ++k) {
        const auto at = 2 * static_cast<Eigen::Index>(k);
        off(at) += emulated::training_value(fresh[k], Observable::stress_ratio).value;
        off(at + 1) += emulated::training_value(fresh[k], Observable::solid_fraction).value;
        covariance.block<2, 2>(at, at) += emulator.noise(fresh[k]);
    }
    use(emulator.with(fresh));
    const double chi2 = off.dot(covariance.llt().solve(off));
    return cdf(complement(boost::math::chi_squared(static_cast<double>(off.size())), chi2));
}

void RunPlanner::add_order(std::size_t runs, const std::string& why) {
    const auto same = std::ranges::find(orders_, why, &Order::why);
    if (same == orders_.end()) {
        orders_.push_back({runs, why});
    } else {
        same->runs += runs;
    }
}

}  // namespace pendular
