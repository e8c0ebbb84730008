#include "calib/emulated_simulation.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <set>
#include <stdexcept>

#include "calib/emulated_structure.h"
#include "sim/effect.h"
#include "sim/seeds.h"

namespace pendular {
namespace {

using dem::Observable;

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

/// States kept with their bridge volume: a few times the readings of a study.
constexpr std::size_t most_filled = 1000;

constexpr double largest_poisson_difference = 0.1;

/// Stress ratio and solid fraction at these states, one after the other.
std::vector<Query> pairs_at(const std::vector<FlowState>& states) {
    std::vector<Query> queries;
    for (const FlowState& state : states) {
        queries.push_back({state, Observable::stress_ratio});
        queries.push_back({state, Observable::solid_fraction});
    }
    return queries;
}

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

std::vector<dem::RunResult> EmulatedSimulation::serving(const Study& study,
                                                        const Fidelity& fidelity,
                                                        const std::vector<dem::RunResult>& runs) {
    // Smaller samples than those asked for, and than the atlas has, feel their own periodicity.
    constexpr int enough_beads = 1000;
    std::vector<dem::RunResult> result;
    std::ranges::copy_if(runs, std::back_inserter(result), [&](const dem::RunResult& run) {
        const auto& p = run.parameters;
        return Emulator::usable(run) && p.beads >= std::min(fidelity.beads, enough_beads) &&
               std::abs(p.poisson_ratio - study.grains.poisson_ratio) <=
                   largest_poisson_difference &&
               (!p.wetting || p.wetting->bridge_force == study.model.bridge_force) &&
               std::ranges::all_of(p.effects, [&](const EffectValues& effect) {
                   return std::ranges::find(study.model.effects, effect.effect,
                                            &ListedEffect::name) != study.model.effects.end();
               });
    });
    return result;
}

EmulatedSimulation::EmulatedSimulation(const Study& study, const std::vector<Condition>& conditions,
                                       const Fidelity& fidelity, std::uint64_t seed,
                                       Workers workers, KnownRuns known)
    : study_(study),
      fidelity_(fidelity),
      seed_(seed),
      workers_(std::move(workers)),
      orders_more_(known.orders_more),
      emulator_(known.runs, std::move(known.scales)),
      inertial_numbers_(inertial_numbers_for(conditions, fidelity.lowest_inertial_number)),
      wet_settings_(wet_settings_for(conditions, study, fidelity.lowest_inertial_number)) {
    predict_for(conditions);
}

FlowState EmulatedSimulation::filled(FlowState state, double liquid_content) const {
    const auto known = std::ranges::find_if(filled_, [&](const Filled& one) {
        return one.liquid_content == liquid_content && one.state.friction == state.friction &&
               one.state.inertial_number == state.inertial_number &&
               one.state.inverse_pressure == state.inverse_pressure &&
               one.state.effects == state.effects;
    });
    if (known != filled_.end()) {
        return known->state;
    }
    state.bridge_volume = bridge_volume_of(emulator_, liquid_content, state);
    filled_.push_front({liquid_content, state});
    if (filled_.size() > most_filled) {
        filled_.pop_back();
    }
    return state;
}

FlowState EmulatedSimulation::wet_state(double friction, const WetSetting& setting) const {
    return filled({friction, setting.inertial_number, setting.inverse_pressure},
                  setting.liquid_content);
}

FlowState EmulatedSimulation::state_of(double friction, const Condition& condition) const {
    FlowState state{allowed(friction + condition.friction_difference), condition.inertial_number};
    for (const EffectValues& effect : condition.grain_effects) {
        state.effects.push_back(in_run_units(effect, condition.normal_stress, study_.grains));
    }
    if (!condition.dry()) {
        state.inverse_pressure = inverse_pressure_of(condition, study_);
        state = filled(state, condition.liquid_content);
    }
    return state;
}

StructureResponse EmulatedSimulation::at_constant_content(StructureResponse response,
                                                          const FlowState& state) const {
    const StructureResponse z = coordination(emulator_, state);
    response.by_friction -= response.by_log_volume * z.by_friction / (z.value + z.by_log_volume);
    return response;
}

StructureResponse EmulatedSimulation::effective_coordination(double friction,
                                                             const Condition& condition) const {
    const FlowState state = state_of(friction, condition);
    return at_constant_content(respond(emulator_, {Observable::effective_coordination}, state),
                               state);
}

StructureResponse EmulatedSimulation::capillary_shear_stress(double friction,
                                                             const Condition& condition) const {
    const FlowState state = state_of(friction, condition);
    StructureResponse stress =
        at_constant_content(respond(emulator_, {Observable::capillary_shear_stress}, state), state);
    stress.value /= state.inverse_pressure;  // over s22; wanted over F0/a^2
    stress.by_friction /= state.inverse_pressure;
    stress.by_log_volume /= state.inverse_pressure;
    return stress;
}

struct EmulatedSimulation::Errors {
    std::vector<Query> coordinations;  ///< two a wet condition
    Eigen::MatrixXd by_coordination;   ///< derivatives of all predictions by those
    Eigen::VectorXd stiffness;         ///< standard error of the correction, common to all
};

double EmulatedSimulation::stiffness_left(const Condition& condition) const {
    return stiffness_share(Emulator::reference_stiffness, condition, study_.grains, fidelity_);
}

Prediction EmulatedSimulation::predict_states(const std::vector<FlowState>& states,
                                              const std::vector<Condition>& conditions,
                                              Errors* errors) const {
    const auto n = static_cast<Eigen::Index>(conditions.size());
    // Stress ratio, solid fraction and overlap; by friction; by bridge volume.
    std::vector<Query> queries;
    for (const FlowState& state : states) {
        for (const std::optional<Input> by :
             {std::optional<Input>(), std::optional(Input::friction),
              std::optional(Input::bridge_volume)}) {
            for (const Observable which :
                 {Observable::stress_ratio, Observable::solid_fraction, Observable::mean_overlap}) {
                queries.push_back({state, which, by});
            }
        }
    }
    const Eigen::VectorXd said = emulator_.mean(queries);
    Prediction prediction{.value = Eigen::VectorXd(2 * n),
                          .jacobian = Eigen::MatrixXd(2 * n, 1),
                          .covariance = {},
                          .run_noise = {}};
    for (Eigen::Index k = 0; k < n; ++k) {
        const Condition& condition = conditions[static_cast<std::size_t>(k)];
        const FlowState& state = states[static_cast<std::size_t>(k)];
        const Eigen::Vector3d value = said.segment<3>(9 * k), slope = said.segment<3>(9 * k + 3);
        const Eigen::Vector3d by_log_volume =
            state.dry() ? Eigen::Vector3d::Zero()
                        : Eigen::Vector3d(state.bridge_volume * said.segment<3>(9 * k + 6));
        // From rigid beads to those of the study: of the shift at the reference stiffness a part
        // 1 - share is there.
        const double share = stiffness_left(condition);
        const double shift = dem::rigidity_shift(value(1), value(2));
        const auto with_stiffness = [&](const Eigen::Vector3d& change) {
            return Eigen::Vector2d(
                change(0),
                change(1) + (1 - share) * shift * (change(1) / value(1) + change(2) / value(2)));
        };
        const Eigen::Vector2d volume_slope = with_stiffness(by_log_volume);
        Eigen::Vector2d total = with_stiffness(slope);
        const Eigen::Vector2d unit(condition.normal_stress, 1);
        if (!state.dry()) {
            const StructureResponse z = coordination(emulator_, state);
            const double log_volume_by_coordination = -1 / (z.value + z.by_log_volume);
            total += volume_slope * log_volume_by_coordination * z.by_friction;
            if (errors != nullptr) {
                const auto column = static_cast<Eigen::Index>(errors->coordinations.size());
                errors->by_coordination.block<2, 1>(2 * k, column) =
                    unit.cwiseProduct(volume_slope) * log_volume_by_coordination;
                errors->by_coordination.col(column + 1) = errors->by_coordination.col(column);
                errors->coordinations.push_back({state, Observable::contact_coordination});
                errors->coordinations.push_back({state, Observable::distant_coordination});
            }
        }
        prediction.value.segment<2>(2 * k) << unit(0) * value(0), value(1) + (1 - share) * shift;
        prediction.jacobian.block<2, 1>(2 * k, 0) = unit.cwiseProduct(total);
        if (errors != nullptr) {
            errors->stiffness(2 * k + 1) =
                share * shift * dem::rigidity_factor_error / dem::rigidity_factor;
        }
    }
    return prediction;
}

Prediction EmulatedSimulation::predict_mean_conditions(
    const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions) const {
    return predict_states(states_of(parameters(0), conditions), conditions, nullptr);
}

Eigen::VectorXd EmulatedSimulation::values_of_conditions(
    const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions) const {
    std::vector<Query> queries;
    for (const FlowState& state : states_of(parameters(0), conditions)) {
        for (const Observable which :
             {Observable::stress_ratio, Observable::solid_fraction, Observable::mean_overlap}) {
            queries.push_back({state, which});
        }
    }
    const Eigen::VectorXd said = emulator_.mean(queries);
    const auto n = static_cast<Eigen::Index>(conditions.size());
    Eigen::VectorXd values(2 * n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Condition& condition = conditions[static_cast<std::size_t>(k)];
        const Eigen::Vector3d value = said.segment<3>(3 * k);
        const double shift = dem::rigidity_shift(value(1), value(2));
        values.segment<2>(2 * k) << condition.normal_stress * value(0),
            value(1) + (1 - stiffness_left(condition)) * shift;
    }
    return values;
}

Prediction EmulatedSimulation::predict_conditions(const Eigen::VectorXd& parameters,
                                                  const std::vector<Condition>& conditions) const {
    const auto n = static_cast<Eigen::Index>(conditions.size());
    const std::vector<FlowState> states = states_of(parameters(0), conditions);
    Errors errors{.coordinations = {},
                  .by_coordination = Eigen::MatrixXd::Zero(2 * n, 2 * n),
                  .stiffness = Eigen::VectorXd::Zero(2 * n)};
    Prediction prediction = predict_states(states, conditions, &errors);
    Eigen::VectorXd unit = Eigen::VectorXd::Ones(2 * n);
    for (Eigen::Index k = 0; k < n; ++k) {
        unit(2 * k) = conditions[static_cast<std::size_t>(k)].normal_stress;
    }
    const auto through_volume =
        errors.by_coordination.leftCols(static_cast<Eigen::Index>(errors.coordinations.size()));
    prediction.run_noise =
        unit.asDiagonal() * emulator_.covariance(pairs_at(states)) * unit.asDiagonal();
    prediction.run_noise +=
        through_volume * emulator_.covariance(errors.coordinations) * through_volume.transpose();
    prediction.covariance = prediction.run_noise + errors.stiffness * errors.stiffness.transpose();
    return prediction;
}

std::vector<FlowState> EmulatedSimulation::states_of(
    double friction, const std::vector<Condition>& conditions) const {
    std::vector<FlowState> states;
    for (const Condition& condition : conditions) {
        states.push_back(state_of(friction, condition));
    }
    return states;
}

Supported EmulatedSimulation::supported() const {
    const auto [least, greatest] = std::ranges::minmax(
        runs(), {}, [](const dem::RunResult& run) { return run.parameters.friction; });
    return {Eigen::VectorXd::Constant(1, least.parameters.friction),
            Eigen::VectorXd::Constant(1, greatest.parameters.friction)};
}

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
    if (targets.empty()) {
        return;
    }
    if (!orders_more_) {
        const std::string note = fmt::format(
            "the emulator extrapolates: {} of the runs it knows; without --no-confirm it orders "
            "runs there",
            why);
        if (std::ranges::find(notes_, note) == notes_.end()) {
            notes_.push_back(note);
        }
        return;
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
