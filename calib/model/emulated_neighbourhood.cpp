#include "calib/model/emulated_neighbourhood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pendular {
namespace {

using dem::Observable;

constexpr std::array of_flow = {Observable::stress_ratio, Observable::solid_fraction,
                                Observable::overlap};
constexpr std::array of_structure = {Observable::contact_coordination,
                                     Observable::distant_coordination};
/// Inputs of the emulator in the order of the columns of the slopes; the derivative by the last,
/// the bridge volume, becomes one by its logarithm.
constexpr std::array inputs = {Input::friction, Input::log_inertial_number, Input::inverse_pressure,
                               Input::bridge_volume};
/// Inputs that matter to a dry state come first among `inputs`.
constexpr std::size_t dry_inputs = 2;

/// Step of the central difference quotient of the responses to effects in ln V0 [1], whose error is
/// of the order of its square.
constexpr double log_volume_step = 1e-4;

/// Calls `use` with the index and the name of each quantity that a state has.
void each_quantity(const FlowState& state, const auto& use) {
    Eigen::Index k = 0;
    for (const Observable which : of_flow) {
        use(k++, which);
    }
    for (const Observable which : of_structure) {
        if (!state.dry()) use(k++, which);
    }
}

}  // namespace

EmulatedNeighbourhood::EmulatedNeighbourhood(const EmulatedSimulation& simulation, double friction,
                                             const std::vector<EffectiveCondition>& conditions)
    : simulation_(simulation) {
    for (const EffectiveCondition& condition : conditions) {
        places_.push_back({.state = simulation.flow_state_at(friction, condition),
                           .liquid_content = condition.liquid_content});
    }
    expand();
    expand_effects();
}

void EmulatedNeighbourhood::expand() {
    std::vector<Query> queries;
    for (const Place& place : places_) {
        const std::size_t count = place.state.dry() ? dry_inputs : inputs.size();
        FlowState plain = place.state;
        plain.stiffness_number = 0;  // that of the training runs
        each_quantity(place.state, [&](Eigen::Index, Observable which) {
            queries.push_back({place.state, which});
            for (std::size_t c = 0; c < count; ++c) {
                queries.push_back({plain, which, inputs[c]});
            }
        });
    }
    const Eigen::VectorXd found = simulation_.emulator().mean(queries);
    Eigen::Index next = 0;
    for (Place& place : places_) {
        const auto count =
            static_cast<Eigen::Index>(place.state.dry() ? dry_inputs : inputs.size());
        each_quantity(place.state, [&](Eigen::Index k, Observable) {
            place.value(k) = found(next++);
            place.slopes.row(k).head(count) = found.segment(next, count).transpose();
            next += count;
        });
        place.slopes.col(3) *= place.state.bridge_volume;
    }
}

void EmulatedNeighbourhood::expand_effects() {
    const auto changed = [&](const FlowState& s) { return simulation_.emulator().changes(s); };
    std::vector<FlowState> at, above, below;
    for (const Place& place : places_) {
        at.push_back(place.state);
        above.push_back(place.state);
        above.back().bridge_volume *= std::exp(log_volume_step);
        below.push_back(place.state);
        below.back().bridge_volume *= std::exp(-log_volume_step);
    }
    if (std::ranges::none_of(at, changed)) return;
    const std::vector<Quantities> here = effects_at(at), up = effects_at(above),
                                  down = effects_at(below);
    for (std::size_t k = 0; k < places_.size(); ++k) {
        places_[k].by_effects = here[k];
        if (!at[k].dry()) {
            places_[k].slopes.col(3) += (up[k] - down[k]) / (2 * log_volume_step);
        }
    }
}

std::vector<EmulatedNeighbourhood::Quantities> EmulatedNeighbourhood::effects_at(
    const std::vector<FlowState>& states) const {
    std::vector<Query> queries;
    for (const FlowState& state : states) {
        if (!simulation_.emulator().changes(state)) continue;
        each_quantity(state, [&](Eigen::Index, Observable which) {
            queries.push_back({state, which});
        });
    }
    const Eigen::VectorXd found = simulation_.emulator().changes_by_causes(queries);
    std::vector<Quantities> result;
    Eigen::Index next = 0;
    for (const FlowState& state : states) {
        result.emplace_back(Quantities::Zero());
        if (!simulation_.emulator().changes(state)) continue;
        each_quantity(state, [&](Eigen::Index k, Observable) { result.back()(k) = found(next++); });
    }
    return result;
}

bool EmulatedNeighbourhood::reaches(const Place& place, const FlowState& state) {
    const bool both_move = place.state.inertial_number > 0 && state.inertial_number > 0;
    return state.dry() == place.state.dry() &&
           (both_move || state.inertial_number == place.state.inertial_number) &&
           // Below 1, the coordination number counts as 1 (`bridge_volume_of`).
           (state.dry() || place.coordination() > 1);
}

Eigen::Vector3d EmulatedNeighbourhood::flow_at(const Place& place, const FlowState& state,
                                               double liquid_content,
                                               const Quantities& by_effects) {
    const Quantities change_by_effects = by_effects - place.by_effects;
    Eigen::Vector4d step = Eigen::Vector4d::Zero();
    step(0) = state.friction - place.state.friction;
    if (state.inertial_number != place.state.inertial_number) {
        step(1) = std::log(state.inertial_number / place.state.inertial_number);
    }
    if (!state.dry()) {
        step(2) = state.inverse_pressure - place.state.inverse_pressure;
        // V0 Z(V0) is proportional to the liquid content.
        const Quantities change = place.slopes * step + change_by_effects;
        const double z = place.coordination();
        step(3) = (std::log(liquid_content / place.liquid_content) - (change(3) + change(4)) / z) /
                  (1 + (place.slopes(3, 3) + place.slopes(4, 3)) / z);
    }
    return (place.value + place.slopes * step + change_by_effects).head<3>();
}

Eigen::VectorXd EmulatedNeighbourhood::values(const Eigen::VectorXd& parameters,
                                              const std::vector<EffectiveCondition>& conditions,
                                              const std::vector<std::size_t>& places) const {
    std::vector<FlowState> states;
    std::vector<EffectiveCondition> beyond;  // where the expansion does not hold
    std::vector<Eigen::Index> places_beyond;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Place& place = places_[places[k]];
        states.push_back(simulation_.unfilled_state_at(parameters(0), conditions[k]));
        states.back().bridge_volume = place.state.bridge_volume;
        if (!reaches(place, states.back())) {
            beyond.push_back(conditions[k]);
            places_beyond.push_back(2 * static_cast<Eigen::Index>(k));
            states.back() = place.state;
        }
    }
    const std::vector<Quantities> by_effects = effects_at(states);
    Eigen::VectorXd result(2 * static_cast<Eigen::Index>(places.size()));
    for (std::size_t k = 0; k < places.size(); ++k) {
        result.segment<2>(2 * static_cast<Eigen::Index>(k)) = simulation_.reading_of(
            flow_at(places_[places[k]], states[k], conditions[k].liquid_content, by_effects[k]),
            conditions[k]);
    }
    if (beyond.empty()) return result;
    const Eigen::VectorXd anew =
        simulation_.predict_flow(parameters, beyond, PredictionPart::values).value;
    for (std::size_t k = 0; k < beyond.size(); ++k) {
        result.segment<2>(places_beyond[k]) = anew.segment<2>(2 * static_cast<Eigen::Index>(k));
    }
    return result;
}

// Defined here, so that the simulation does not depend on its neighbourhoods.
std::unique_ptr<const FlowNeighbourhood> EmulatedSimulation::neighbourhood(
    const Eigen::VectorXd& parameters, const std::vector<EffectiveCondition>& conditions) const {
    return std::make_unique<EmulatedNeighbourhood>(*this, parameters(0), conditions);
}

}  // namespace pendular
