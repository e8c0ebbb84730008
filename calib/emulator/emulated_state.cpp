#include "calib/emulator/emulated_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "calib/emulator/emulated_observables.h"

namespace pendular {
namespace {

using dem::Observable;

/// Emulated value of an observable, followed by its derivatives, with the covariance of all.
struct Jet {
    Eigen::VectorXd value;
    Eigen::MatrixXd covariance;
};

/// Jets of an observable at several states, without the derivatives if there are to be no slopes.
std::vector<Jet> jets_of(const Emulator& emulator, const std::vector<FlowState>& states,
                         Observable which, bool slopes) {
    std::vector<Query> queries;
    std::vector<Eigen::Index> begins;
    for (const FlowState& state : states) {
        begins.push_back(std::ssize(queries));
        queries.push_back({state, which});
        if (!slopes) continue;
        queries.push_back({state, which, Input::friction});
        queries.push_back({state, which, Input::log_inertial_number});
        if (state.dry()) continue;
        queries.push_back({state, which, Input::inverse_pressure});
        queries.push_back({state, which, Input::bridge_volume});
    }
    begins.push_back(std::ssize(queries));
    const Eigen::VectorXd mean = emulator.mean(queries);
    const Eigen::MatrixXd covariance = emulator.covariance(queries);
    std::vector<Jet> jets;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const Eigen::Index at = begins[k], size = begins[k + 1] - at;
        jets.push_back({mean.segment(at, size), covariance.block(at, at, size, size)});
    }
    return jets;
}

Estimate estimate(const Jet& jet, Eigen::Index k) {
    const double variance = jet.covariance(k, k);
    return {jet.value(k), variance > 0 ? std::sqrt(variance) : 0.0};
}

/// Converts the solid fraction of rigid grains to grains of a stiffness number kappa: the part
/// reference/kappa of the rigidity shift at the reference stiffness number applies. The errors of
/// the overlap are neglected. The error of the correction is added unless runs of other stiffness
/// numbers train the emulator and `corrected`, so that its own error contains it.
void soften(Jet& fraction, const Jet& overlap, double stiffness_number, bool corrected) {
    const double part = emulated::reference_stiffness / stiffness_number;
    const double rigid = fraction.value(0), shift = dem::rigidity_shift(rigid, overlap.value(0));
    Eigen::VectorXd shifts =
        shift * (fraction.value / rigid + overlap.value / overlap.value(0));  // slopes of a product
    shifts(0) = shift;
    fraction.value += part * shifts;
    if (corrected) return;
    const Eigen::VectorXd error =
        (1 - part) * dem::rigidity_factor_error / dem::rigidity_factor * shifts;
    fraction.covariance += error * error.transpose();
}

}  // namespace

std::vector<Observable> observables_of(const FlowState& state) {
    std::vector<Observable> result;
    std::ranges::copy_if(
        emulated::observables(), std::back_inserter(result),
        [&](Observable which) { return !state.dry() || !emulated::of_bridges(which); });
    return result;
}

std::vector<EmulatedObservable> emulated_at(const Emulator& emulator, const FlowState& state,
                                            double stiffness_number,
                                            const std::vector<Observable>& wanted) {
    for (const Observable which : wanted)
        if (state.dry() && emulated::of_bridges(which))
            throw std::invalid_argument(fmt::format(
                "dry grains have no {}", dem::observable_names[static_cast<std::size_t>(which)]));
    return emulated_at(emulator, {state}, stiffness_number, wanted, true).front();
}

std::vector<std::vector<EmulatedObservable>> emulated_at(const Emulator& emulator,
                                                         std::vector<FlowState> states,
                                                         double stiffness_number,
                                                         const std::vector<Observable>& wanted,
                                                         bool slopes) {
    for (FlowState& state : states)
        state.stiffness_number = stiffness_number;
    std::vector<std::vector<EmulatedObservable>> result(states.size());
    for (const Observable which : wanted) {
        std::vector<FlowState> having;
        std::vector<std::size_t> places;
        for (std::size_t k = 0; k < states.size(); ++k) {
            if (states[k].dry() && emulated::of_bridges(which)) continue;
            having.push_back(states[k]);
            places.push_back(k);
        }
        if (having.empty()) continue;
        std::vector<Jet> jets = jets_of(emulator, having, which, slopes);
        const std::vector<Jet> overlaps =
            which == Observable::solid_fraction
                ? jets_of(emulator, having, Observable::overlap, slopes)
                : std::vector<Jet>();
        for (std::size_t k = 0; k < having.size(); ++k) {
            Jet& jet = jets[k];
            if (which == Observable::solid_fraction) {
                soften(jet, overlaps[k], stiffness_number, emulator.knows_stiffness());
            } else if (which == Observable::overlap) {
                const double part = emulated::reference_stiffness / stiffness_number;
                jet.value *= part;
                jet.covariance *= part * part;
            }
            EmulatedObservable one{.which = which, .value = estimate(jet, 0), .slopes = {}};
            for (Eigen::Index i = 1; i < jet.value.size(); ++i)
                one.slopes.push_back(estimate(jet, i));
            result[places[k]].push_back(std::move(one));
        }
    }
    return result;
}

using dem::Observable;

StructureResponse respond(const Emulator& emulator, const std::vector<Observable>& sum,
                          const FlowState& state) {
    StructureResponse response;
    for (const Observable which : sum) {
        const Eigen::VectorXd found = emulator.mean({{state, which},
                                                     {state, which, Input::friction},
                                                     {state, which, Input::bridge_volume}});
        response.value += found(0);
        response.by_friction += found(1);
        response.by_log_volume += found(2) * state.bridge_volume;
    }
    return response;
}

StructureResponse coordination(const Emulator& emulator, const FlowState& state) {
    return respond(emulator, {Observable::contact_coordination, Observable::distant_coordination},
                   state);
}

double bridge_volume_of(const Emulator& emulator, double liquid_content, FlowState state) {
    // ln V0 + ln Z(V0) = ln(pi Phi_L/(3 Phi_S)), by Newton's method: the error of the next step is
    // about the square of this one.
    constexpr double tolerance = 1e-4;
    state.bridge_volume = dem::bridge_volume(liquid_content, dem::typical_coordination);
    for (int k = 0; k < 50; ++k) {
        const StructureResponse z = coordination(emulator, state);
        const double value = std::max(1.0, z.value);
        // At least 0.5: the step is at most twice that of a constant Z, also where Z(V0) falls.
        const double step =
            std::log(dem::bridge_volume(liquid_content, value) / state.bridge_volume) /
            std::max(0.5, 1 + z.by_log_volume / value);
        state.bridge_volume *= std::exp(step);
        if (std::abs(step) < tolerance) {
            break;
        }
    }
    return state.bridge_volume;
}

}  // namespace pendular
