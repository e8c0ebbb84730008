#include "workflow/state_prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "data/input_error.h"
#include "data/quantities/number.h"
#include "workflow/study_input.h"

namespace pendular {
namespace {

constexpr int most_points = 10'000;  ///< ten for each dot of the figure; nothing finer is seen
/// Largest ratio of the ends of a curve [1], beyond which powers of their ratio lose digits or
/// overflow; simulated reduced pressures differ by less than a factor of 1e4.
constexpr double widest = 1e12;

/// Emulator trained on the runs of the atlas and of a store, which may be null, or on the runs of
/// an earlier result.
/// @throws InputError where there are too few runs
Emulator emulator_of_known_runs(const Fidelity& fidelity, const RunStore* store,
                                const TrainingRuns* training) {
    if (training) return Emulator(training->runs, atlas_hyperparameters());
    auto known = known_runs(Study{}, fidelity, store);
    if (!known) {
        throw InputError(
            "there are too few simulations to predict from; name an atlas in PENDULAR_ATLAS, or "
            "simulate with 'pendular campaign'");
    }
    return Emulator(known->runs, std::move(known->hyperparameters));
}

/// Checks that a predicted solid fraction is possible; the correction to very soft grains may give
/// values beyond any packing.
/// @throws InputError where the solid fraction is not that of a dense flow
void demand_physical(const std::vector<EmulatedObservable>& observables, double stiffness_number) {
    for (const auto& one : observables) {
        if (one.which == dem::Observable::solid_fraction &&
            !(one.value.value >= KnownRange::lowest_fraction &&
              one.value.value <= KnownRange::highest_fraction)) {
            throw InputError(
                fmt::format("--stiffness-number {:g}: the solid fraction would be {:.3g}, which is "
                            "not between {} and {}; give a larger stiffness number",
                            stiffness_number, one.value.value, KnownRange::lowest_fraction,
                            KnownRange::highest_fraction));
        }
    }
}

/// Values of the closures for a wet state from its predicted observables; empty for a dry state.
std::optional<closures::ClosureValues> closures_at(
    const Emulator& emulator, const FlowState& state,
    const std::vector<EmulatedObservable>& observables) {
    if (state.dry()) return {};
    using dem::Observable;
    const auto value = [&](Observable which) {
        return std::ranges::find(observables, which, &EmulatedObservable::which)->value.value;
    };
    const double pressure = 1 / state.inverse_pressure;
    const closures::State network{.reduced_pressure = pressure,
                                  .solid_fraction = value(Observable::solid_fraction),
                                  .contact_coordination = value(Observable::contact_coordination),
                                  .distant_coordination = value(Observable::distant_coordination),
                                  .distant_force = value(Observable::distant_force)};
    const closures::CapillaryStress capillary{
        .normal = pressure * value(Observable::capillary_stress_22),
        .shear = pressure * value(Observable::capillary_shear_stress)};
    const FlowState dry{.friction = state.friction,
                        .inertial_number = state.inertial_number,
                        .stiffness_number = state.stiffness_number};
    const double dry_stress_ratio = emulator.mean({{dry, Observable::stress_ratio}})(0);
    return closures::closure_values(network, capillary, value(Observable::stress_ratio),
                                    dry_stress_ratio, value(Observable::liquid_content));
}

}  // namespace

VariedQuantity VariedQuantity::parsed(const std::string& text, int points) {
    const std::vector<std::string> names = {"friction", "inertial-number", "reduced-pressure",
                                            "bridge-volume", "liquid-content"};
    const auto equals = std::min(text.find('='), text.size());
    const auto colon = std::min(text.find(':', equals), text.size());
    const std::string name = text.substr(0, equals);
    const auto number = [&](std::size_t begin, std::size_t end) {
        return begin < text.size() ? parse_number(text.substr(begin, end - begin)) : std::nullopt;
    };
    const auto from = number(equals + 1, colon), to = number(colon + 1, text.size());
    if (std::ranges::find(names, name) == names.end()) {
        throw InputError(fmt::format("--along {}: '{}' is no quantity that can be varied; {}", text,
                                     name, did_you_mean(name, names)));
    }
    if (points < 2 || points > most_points) {
        throw InputError(fmt::format(
            "--points {}: 2 to {} are needed; the figure is {} dots wide, and more would not show",
            points, most_points, 1000));
    }
    if (from && to && *from > 0 && !(*to / *from <= widest)) {
        throw InputError(
            fmt::format("--along {}: the second number is more than {:g} times the first; no "
                        "quantity of a flow "
                        "of grains varies so much: give a narrower range",
                        text, widest));
    }
    if (!from || !to || !(*from < *to)) {
        throw InputError(fmt::format(
            "--along {}: two numbers are needed, the lesser first, as in {}=0.5:10", text, name));
    }
    VariedQuantity varied{.name = name, .from = *from, .to = *to, .points = points};
    varied.logarithmic = name != "friction" && *from > 0;
    std::ranges::replace(varied.name, '-', '_');
    return varied;
}

double VariedQuantity::at(int k) const {
    const double part = static_cast<double>(k) / (points - 1);
    return logarithmic ? from * std::pow(to / from, part) : from + (to - from) * part;
}

void VariedQuantity::set(RequestedState& requested, double value) const {
    if (name == "friction") {
        requested.friction = value;
    } else if (name == "inertial_number") {
        requested.inertial_number = value;
    } else if (name == "reduced_pressure") {
        requested.reduced_pressure = value;
    } else if (name == "bridge_volume") {
        requested.bridge_volume = value;
    } else {
        requested.liquid_content = value;
    }
}

StatePredictor::StatePredictor(const Fidelity& fidelity, const RunStore* store,
                               double stiffness_number, const TrainingRuns* training)
    : fidelity_(fidelity),
      stiffness_number_(stiffness_number),
      emulator_(emulator_of_known_runs(fidelity, store, training)),
      known_(emulator_) {
    check_stiffness_number(stiffness_number);
}

void StatePredictor::check_stiffness_number(double stiffness_number) {
    if (!(stiffness_number >= 100)) {  // as for every simulation (run_parameters.cpp)
        throw InputError(
            fmt::format("--stiffness-number {}: 100 or more is needed", stiffness_number));
    }
}

FlowState StatePredictor::state_of(RequestedState requested) const {
    requested.stiffness_number = stiffness_number_;
    return requested.state(emulator_, known_);
}

bool StatePredictor::supports(const RequestedState& requested) const {
    return known_.why_unsupported(state_of(requested)).empty();
}

StatePrediction StatePredictor::at(const RequestedState& requested) const {
    const FlowState state = state_of(requested);
    if (const std::string why = known_.why_unsupported(state); !why.empty()) {
        throw InputError(unsupported(requested, state, why));
    }
    std::vector<EmulatedObservable> observables = observables_at(state);
    const auto closures = closures_at(emulator_, state, observables);
    return {.state = state,
            .observables = std::move(observables),
            .stiffness_number = stiffness_number_,
            .beyond = emulator_.beyond(state),
            .runs = emulator_.runs().size(),
            .closures = closures};
}

PredictionCurve StatePredictor::along(RequestedState requested,
                                      const VariedQuantity& varied) const {
    PredictionCurve curve{.variable = varied.name, .stiffness_number = stiffness_number_};
    std::optional<RequestedState> first_left_out;
    for (int k = 0; k < varied.points; ++k) {
        varied.set(requested, varied.at(k));
        const FlowState state = state_of(requested);
        if (std::string why = known_.why_unsupported(state); !why.empty()) {
            ++curve.left_out;
            if (!first_left_out) {
                first_left_out = requested, curve.why_left_out = std::move(why);
            }
            continue;
        }
        curve.at.push_back(varied.at(k));
        curve.states.push_back(state);
        curve.observables.push_back(observables_at(state));
        if (const auto closures = closures_at(emulator_, state, curve.observables.back()))
            curve.closures.push_back(*closures);
    }
    if (curve.at.size() < 2) {
        throw InputError(fmt::format(
            "--along: {} of {} states can be predicted, a curve needs 2; {}", curve.at.size(),
            varied.points,
            unsupported(*first_left_out, state_of(*first_left_out), curve.why_left_out)));
    }
    return curve;
}

std::optional<closures::ClosureValues> StatePredictor::closures_of(
    const dem::RunResult& run) const {
    const dem::RunParameters& p = run.parameters;
    const FlowState dry{.friction = p.friction,
                        .inertial_number = p.inertial_number,
                        .stiffness_number = p.stiffness_number};
    // The dry stress ratio is emulated without effects and at the default damping: a run that
    // differs in what dry grains feel has another one.
    const bool others = std::ranges::any_of(p.effects, [](const EffectValues& values) {
        return built_in_effect(values.effect).touches != Touches::wet;
    });
    const bool damped_alike = p.damping == dem::RunParameters{}.damping;
    if (!p.wetting || others || !damped_alike || !known_.why_unsupported(dry).empty()) return {};
    const double ratio = emulator_.mean({{dry, dem::Observable::stress_ratio}})(0);
    return closures::closure_values(run, ratio);
}

dem::RunParameters StatePredictor::run_for(const RequestedState& requested) const {
    const FlowState state = state_of(requested);
    dem::RunParameters run = run_of(with_known_coordination(requested, state, emulator_, known_),
                                    fidelity_, stiffness_number_);
    if (const std::string why = why_impossible(run); !why.empty()) {
        throw InputError("--simulate: " + why);
    }
    return run;
}

std::vector<EmulatedObservable> StatePredictor::observables_at(const FlowState& state) const {
    auto observables = emulated_at(emulator_, state, stiffness_number_, observables_of(state));
    demand_physical(observables, stiffness_number_);
    return observables;
}

std::string StatePredictor::unsupported(const RequestedState& requested, const FlowState& state,
                                        const std::string& why) const {
    return unsupported_text(requested, state, why, emulator_, known_, fidelity_, stiffness_number_);
}

}  // namespace pendular
