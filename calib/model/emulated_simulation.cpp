#include "calib/model/emulated_simulation.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/emulated_state.h"
#include "calib/model/study_state.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/state.h"

namespace pendular {
namespace {

using dem::Observable;
using emulated::pairs_at;

/// Maximum number of cached states with their bridge volume: some hundred times the number of
/// readings of a study.
constexpr std::size_t most_filled = 20000;

std::size_t hash_of(const FlowState& state, double liquid_content) {
    std::size_t hash = 0;
    const auto mix = [&](double value) {
        hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(value);
    };
    mix(liquid_content), mix(state.friction), mix(state.inertial_number);
    mix(state.inverse_pressure), mix(state.stiffness_number);
    for (const EffectValues& effect : state.effects) {
        std::ranges::for_each(effect.values, mix);
    }
    return hash;
}

bool same_but_for_volume(const FlowState& a, const FlowState& b) {
    return a.friction == b.friction && a.inertial_number == b.inertial_number &&
           a.inverse_pressure == b.inverse_pressure && a.stiffness_number == b.stiffness_number &&
           a.effects == b.effects;
}

}  // namespace

EmulatedSimulation::EmulatedSimulation(const Study& study, const Fidelity& fidelity,
                                       Emulator emulator)
    : study_(study), fidelity_(fidelity), emulator_(std::move(emulator)) {}

double EmulatedSimulation::allowed(double friction) const {
    return std::clamp(friction, parameters_[0].lower, parameters_[0].upper);
}

FlowState EmulatedSimulation::filled(const FlowState& state, double liquid_content) const {
    const std::size_t hash = hash_of(state, liquid_content);
    {
        const std::scoped_lock lock(cache_->mutex);
        const auto [begin, end] = cache_->filled.equal_range(hash);
        for (auto known = begin; known != end; ++known) {
            if (known->second.liquid_content == liquid_content &&
                same_but_for_volume(known->second.state, state)) {
                return known->second.state;
            }
        }
    }
    FlowState result = state;
    result.bridge_volume = bridge_volume_of(emulator_, liquid_content, state);
    const std::scoped_lock lock(cache_->mutex);
    if (cache_->filled.size() >= most_filled) {
        cache_->filled.clear();
    }
    cache_->filled.emplace(hash, Filled{liquid_content, result});
    return result;
}

FlowState EmulatedSimulation::unfilled_state_at(double friction,
                                                const EffectiveCondition& condition) const {
    FlowState state{allowed(friction + condition.friction_difference), condition.inertial_number};
    state.stiffness_number = stiffness_number_of(condition, study_.grains, fidelity_);
    for (const EffectValues& effect : condition.grain_effects) {
        state.effects.push_back(in_run_units(effect, condition.normal_stress, study_.grains));
    }
    if (!condition.dry()) {
        state.inverse_pressure = inverse_pressure_of(condition, study_);
    }
    return state;
}

FlowState EmulatedSimulation::flow_state_at(double friction,
                                            const EffectiveCondition& condition) const {
    const FlowState state = unfilled_state_at(friction, condition);
    return state.dry() ? state : filled(state, condition.liquid_content);
}

Eigen::Vector2d EmulatedSimulation::reading_of(const Eigen::Vector3d& flow,
                                               const EffectiveCondition& condition) const {
    return {condition.normal_stress * flow(0),
            flow(1) + (1 - stiffness_left(condition)) * dem::rigidity_shift(flow(1), flow(2))};
}

StructureResponse EmulatedSimulation::at_constant_content(StructureResponse response,
                                                          const FlowState& state) const {
    const StructureResponse z = coordination(emulator_, state);
    response.by_friction -= response.by_log_volume * z.by_friction / (z.value + z.by_log_volume);
    return response;
}

StructureResponse EmulatedSimulation::effective_coordination(
    double friction, const EffectiveCondition& condition) const {
    const FlowState state = flow_state_at(friction, condition);
    return at_constant_content(respond(emulator_, {Observable::effective_coordination}, state),
                               state);
}

StructureResponse EmulatedSimulation::approximate_coordination(
    double friction, const EffectiveCondition& condition) const {
    const FlowState state = flow_state_at(friction, condition);
    StructureResponse sum = respond(emulator_, {Observable::contact_coordination}, state);
    const StructureResponse distant = respond(emulator_, {Observable::distant_coordination}, state);
    sum.value += closures::usual_distant_force * distant.value;
    sum.by_friction += closures::usual_distant_force * distant.by_friction;
    sum.by_log_volume += closures::usual_distant_force * distant.by_log_volume;
    return at_constant_content(sum, state);
}

StructureResponse EmulatedSimulation::capillary_stress(Observable which, double friction,
                                                       const EffectiveCondition& condition) const {
    const FlowState state = flow_state_at(friction, condition);
    StructureResponse stress = at_constant_content(respond(emulator_, {which}, state), state);
    stress.value /= state.inverse_pressure;  // from s_cap/s22 to a^2 s_cap/F0
    stress.by_friction /= state.inverse_pressure;
    stress.by_log_volume /= state.inverse_pressure;
    return stress;
}

StructureResponse EmulatedSimulation::capillary_normal_stress(
    double friction, const EffectiveCondition& condition) const {
    return capillary_stress(Observable::capillary_stress_22, friction, condition);
}

StructureResponse EmulatedSimulation::capillary_shear_stress(
    double friction, const EffectiveCondition& condition) const {
    return capillary_stress(Observable::capillary_shear_stress, friction, condition);
}

struct EmulatedSimulation::Errors {
    /// Two queries for each wet condition: coordination by contacts and by distant bridges.
    std::vector<Query> coordinations;
    /// Derivatives of predictions by coordinations, as row, column and value.
    std::vector<Eigen::Triplet<double>> by_coordination;
    /// Standard error of the stiffness correction of each prediction, fully correlated between all.
    Eigen::VectorXd stiffness;
};

double EmulatedSimulation::stiffness_left(const EffectiveCondition& condition) const {
    return stiffness_share(emulated::reference_stiffness, condition, study_.grains, fidelity_);
}

Prediction EmulatedSimulation::predict_slopes(const std::vector<FlowState>& states,
                                              const std::vector<EffectiveCondition>& conditions,
                                              Errors* errors) const {
    const auto n = static_cast<Eigen::Index>(conditions.size());
    // Nine queries for each state: stress ratio, solid fraction and overlap, then their derivatives
    // by friction, then by bridge volume.
    std::vector<Query> queries;
    for (const FlowState& state : states) {
        for (const std::optional<Input> by :
             {std::optional<Input>(), std::optional(Input::friction),
              std::optional(Input::bridge_volume)}) {
            for (const Observable which :
                 {Observable::stress_ratio, Observable::solid_fraction, Observable::overlap}) {
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
        const EffectiveCondition& condition = conditions[static_cast<std::size_t>(k)];
        const FlowState& state = states[static_cast<std::size_t>(k)];
        const Eigen::Vector3d value = said.segment<3>(9 * k), slope = said.segment<3>(9 * k + 3);
        const Eigen::Vector3d by_log_volume =
            state.dry() ? Eigen::Vector3d::Zero()
                        : Eigen::Vector3d(state.bridge_volume * said.segment<3>(9 * k + 6));
        // From rigid grains to the study's grains: the part 1 - share of the rigidity shift at the
        // reference stiffness number applies.
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
                const Eigen::Vector2d change =
                    unit.cwiseProduct(volume_slope) * log_volume_by_coordination;
                for (const Eigen::Index one : {0, 1}) {
                    for (const Eigen::Index row : {0, 1}) {
                        errors->by_coordination.emplace_back(2 * k + row, column + one,
                                                             change(row));
                    }
                }
                errors->coordinations.push_back({state, Observable::contact_coordination});
                errors->coordinations.push_back({state, Observable::distant_coordination});
            }
        }
        prediction.value.segment<2>(2 * k) << unit(0) * value(0), value(1) + (1 - share) * shift;
        prediction.jacobian.block<2, 1>(2 * k, 0) = unit.cwiseProduct(total);
        if (errors != nullptr && !emulator_.knows_stiffness()) {
            errors->stiffness(2 * k + 1) =
                share * shift * dem::rigidity_factor_error / dem::rigidity_factor;
        }
    }
    return prediction;
}

Prediction EmulatedSimulation::predict_flow(const Eigen::VectorXd& parameters,
                                            const std::vector<EffectiveCondition>& conditions,
                                            PredictionPart what) const {
    std::vector<FlowState> states;
    for (const EffectiveCondition& condition : conditions) {
        states.push_back(flow_state_at(parameters(0), condition));
    }
    switch (what) {
        case PredictionPart::values:
            return {.value = predict_values(states, conditions),
                    .jacobian = {},
                    .covariance = {},
                    .run_noise = {}};
        case PredictionPart::slopes:
            return predict_slopes(states, conditions, nullptr);
        default:
            return predict_all(states, conditions);
    }
}

Eigen::VectorXd EmulatedSimulation::predict_values(
    const std::vector<FlowState>& states, const std::vector<EffectiveCondition>& conditions) const {
    std::vector<Query> queries;
    for (const FlowState& state : states) {
        for (const Observable which :
             {Observable::stress_ratio, Observable::solid_fraction, Observable::overlap}) {
            queries.push_back({state, which});
        }
    }
    const Eigen::VectorXd said = emulator_.mean(queries);
    const auto n = static_cast<Eigen::Index>(conditions.size());
    Eigen::VectorXd values(2 * n);
    for (Eigen::Index k = 0; k < n; ++k) {
        values.segment<2>(2 * k) =
            reading_of(said.segment<3>(3 * k), conditions[static_cast<std::size_t>(k)]);
    }
    return values;
}

Prediction EmulatedSimulation::predict_all(
    const std::vector<FlowState>& states, const std::vector<EffectiveCondition>& conditions) const {
    const auto n = static_cast<Eigen::Index>(conditions.size());
    Errors errors{
        .coordinations = {}, .by_coordination = {}, .stiffness = Eigen::VectorXd::Zero(2 * n)};
    Prediction prediction = predict_slopes(states, conditions, &errors);
    Eigen::VectorXd unit = Eigen::VectorXd::Ones(2 * n);
    for (Eigen::Index k = 0; k < n; ++k) {
        unit(2 * k) = conditions[static_cast<std::size_t>(k)].normal_stress;
    }
    Eigen::SparseMatrix<double> through_volume(2 * n, std::ssize(errors.coordinations));
    through_volume.setFromTriplets(errors.by_coordination.begin(), errors.by_coordination.end());
    prediction.run_noise =
        unit.asDiagonal() * emulator_.covariance(pairs_at(states)) * unit.asDiagonal();
    const Eigen::MatrixXd half = through_volume * emulator_.covariance(errors.coordinations);
    prediction.run_noise += half * through_volume.transpose();
    prediction.covariance = prediction.run_noise + errors.stiffness * errors.stiffness.transpose();
    return prediction;
}

ParameterBounds EmulatedSimulation::bounds() const {
    const auto [least, greatest] = std::ranges::minmax(
        emulator_.runs(), {}, [](const dem::RunResult& run) { return run.parameters.friction; });
    return {Eigen::VectorXd::Constant(1, least.parameters.friction),
            Eigen::VectorXd::Constant(1, greatest.parameters.friction)};
}

}  // namespace pendular
