// Which runs an emulator orders: beyond those it knows, and at the optimum of a fit.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <set>

#include "calib/emulated_observables.h"
#include "calib/emulated_simulation.h"
#include "sim/seeds.h"

namespace pendular {
namespace {

using dem::Observable;
using emulated::pairs_at;

/// Runs that one round of confirmation orders at least and at most.
constexpr std::size_t fewest_confirming = 4, most_confirming = 16;
/// Below this probability fresh runs do not agree with what was said of them.
constexpr double significance = 0.01;

/// How far from a friction runs are ordered, in ln(friction + 0.05).
constexpr double spread = 0.2;
/// Factor by which the variance is to fall where there was no run yet.
constexpr double unknown = 1e9;

/// What counts as equally grave an error of stress ratio and of solid fraction [1].
const Eigen::Vector2d grave(0.01, 0.002);

/// The noise of a run to come, from the mean of those known.
Eigen::Matrix2d expected_noise(const Emulator& emulator, const Fidelity& fidelity) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const auto& run : emulator.runs()) {
        sum += emulator.noise(run) * run.parameters.beads * run.strain_averaged;
    }
    return sum / (static_cast<double>(emulator.runs().size()) * fidelity.beads * fidelity.strain);
}

/// Whether two states need no two runs.
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

EmulatedSimulation::Candidates EmulatedSimulation::candidates(double friction, bool wet) const {
    const auto states_at = [&](double at) {
        std::vector<FlowState> states;
        if (has_grain_effects()) {
            // Their size goes with the reading: its own state, once.
            for (const Condition& condition : conditions()) {
                Condition simulated = condition;
                simulated.inertial_number =
                    std::max(condition.inertial_number, fidelity_.lowest_inertial_number);
                const FlowState state = state_of(at, simulated);
                if (condition.dry() != wet &&
                    std::ranges::none_of(states, [&](const auto& s) { return near(s, state); })) {
                    states.push_back(state);
                }
            }
        } else if (wet) {
            for (const WetSetting& setting : wet_settings_) {
                states.push_back(wet_state(at, setting));
            }
        } else {
            for (const double inertial_number : inertial_numbers_) {
                states.push_back({at, inertial_number});
            }
        }
        return states;
    };
    return {.at_friction = states_at(friction),
            .below = states_at(allowed(friction_at(-spread, friction))),
            .above = states_at(allowed(friction_at(spread, friction)))};
}

bool EmulatedSimulation::has_grain_effects() const {
    const auto all = conditions();
    return std::ranges::any_of(all, [](const Condition& c) { return !c.grain_effects.empty(); });
}

std::vector<FlowState> EmulatedSimulation::most_informative(const std::vector<FlowState>& targets,
                                                            const std::vector<FlowState>& from,
                                                            double excess) const {
    std::vector<FlowState> all = targets;
    all.insert(all.end(), from.begin(), from.end());
    Eigen::MatrixXd covariance = emulator_.covariance(pairs_at(all));
    const Eigen::Matrix2d noise = expected_noise(emulator_, fidelity_);
    const auto wanted = 2 * static_cast<Eigen::Index>(targets.size());
    const Eigen::VectorXd weight =
        grave.cwiseInverse().cwiseAbs2().replicate(static_cast<Eigen::Index>(targets.size()), 1);
    const auto variance = [&] { return weight.dot(covariance.diagonal().head(wanted)); };
    const double enough = variance() / std::max(1.0, excess);
    std::vector<FlowState> chosen;
    while (chosen.size() < most_confirming &&
           (chosen.size() < fewest_confirming || variance() > enough)) {
        // A run at c lowers the covariance by C(., c) [C(c, c) + noise]^-1 C(c, .).
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

void EmulatedSimulation::improve(const Eigen::VectorXd& parameters, double excess) {
    confirmed_ = rounds_ > 0;  // unless fresh runs say otherwise
    const auto all = conditions();
    const auto wet = [](const Condition& c) { return !c.dry(); };
    if (!std::ranges::all_of(all, wet)) {
        learn(parameters(0), false, excess);
    }
    if (std::ranges::any_of(all, wet)) {
        learn(parameters(0), true, excess);
    }
    ++rounds_;
}

void EmulatedSimulation::learn_wet(const Eigen::VectorXd& parameters, int turns) {
    // What lies beyond the known runs first, whatever rounds the dry readings took.
    order_beyond(parameters(0), true);
    // The first runs only confirm; more are asked for where predictions stay too uncertain.
    confirm(parameters(0), true, began_wet_ ? 1 + turns : 1);
    began_wet_ = true;
}

void EmulatedSimulation::learn(double friction, bool wet, double excess) {
    if (rounds_ == 0) {
        order_beyond(friction, wet);
    } else {
        confirm(friction, wet, excess);
    }
}

void EmulatedSimulation::order_beyond(double friction, bool wet) {
    const Candidates all = candidates(friction, wet);
    std::vector<FlowState> targets, from;
    std::string why;
    for (std::size_t k = 0; k < all.at_friction.size(); ++k) {
        if (const std::string text = emulator_.beyond(all.at_friction[k]); !text.empty()) {
            why = text;
            targets.push_back(all.at_friction[k]);
            from.insert(from.end(), {all.below[k], all.at_friction[k], all.above[k]});
        }
    }
    if (targets.empty() || !orders_more_) {
        return;  // a calibration names the readings whose predictions runs do not support
    }
    // The error to begin with is that of a guess.
    order(most_informative(targets, from, unknown), "since " + why + " of the known runs");
}

void EmulatedSimulation::confirm(double friction, bool wet, double excess) {
    if (!orders_more_) {
        return;
    }
    const Candidates all = candidates(friction, wet);
    std::vector<FlowState> from = all.at_friction;
    from.insert(from.end(), all.below.begin(), all.below.end());
    from.insert(from.end(), all.above.begin(), all.above.end());
    const double p = order(most_informative(all.at_friction, from, excess),
                           wet ? "to confirm the wet readings" : "to confirm the optimum");
    if (p < significance) {
        confirmed_ = false;
        notes_.push_back(fmt::format(
            "fresh runs {} differed from what the emulator had said of them (p = {:.2g}); "
            "it has learned them since",
            wet ? "at the wet readings" : "at the optimum", p));
    }
}

double EmulatedSimulation::order(const std::vector<FlowState>& states, const std::string& why) {
    std::set<std::string> known;
    for (const auto& run : runs()) {
        known.insert(dem::described(run.parameters));
    }
    std::vector<dem::RunParameters> wanted;
    for (const FlowState& state : states) {
        dem::RunParameters run = run_at(state, study_, fidelity_);
        // A run that is known already would confirm nothing.
        do {
            run.seed = seed_of_run(seed_, ordered_++);
        } while (known.contains(dem::described(run)));
        wanted.push_back(run);
    }
    std::vector<dem::RunResult> fresh;
    std::vector<FlowState> places;
    for (const auto& run : run_all(wanted, workers_)) {
        const FlowState state = Emulator::state_of(run.parameters);
        if (Emulator::usable(run)) {
            fresh.push_back(run);
            places.push_back(state);
        } else {
            notes_.push_back(fmt::format("a run at {} is not used: it {}", describe(state),
                                         !run.failure.empty() ? "failed, " + run.failure
                                         : run.crystallised   ? "crystallised"
                                                              : "was not steady"));
        }
    }
    add_order(wanted.size(), why);
    if (fresh.empty()) {
        return 0;
    }
    const auto queries = pairs_at(places);
    Eigen::VectorXd off = -emulator_.mean(queries);
    Eigen::MatrixXd covariance = emulator_.covariance(queries);
    for (std::size_t k = 0; k < fresh.size(); ++k) {
        const auto at = 2 * static_cast<Eigen::Index>(k);
        off(at) += Emulator::taught(fresh[k], Observable::stress_ratio).value;
        off(at + 1) += Emulator::taught(fresh[k], Observable::solid_fraction).value;
        covariance.block<2, 2>(at, at) += emulator_.noise(fresh[k]);
    }
    emulator_ = emulator_.with(fresh);
    filled_.clear();
    const double chi2 = off.dot(covariance.llt().solve(off));
    return cdf(complement(boost::math::chi_squared(static_cast<double>(off.size())), chi2));
}

void EmulatedSimulation::add_order(std::size_t runs, const std::string& why) {
    const auto same = std::ranges::find(orders_, why, &Order::why);
    if (same == orders_.end()) {
        orders_.push_back({runs, why});
    } else {
        same->runs += runs;
    }
}

}  // namespace pendular
