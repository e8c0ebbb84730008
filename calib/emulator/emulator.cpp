#include "calib/emulator/emulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "sim/catalogue/effect.h"

namespace pendular {

using dem::Observable;
using namespace emulated;

namespace {

/// Usual range of an effect's amplitude in studies, in the units of a run (grain diameter, grain
/// mass and normal stress are 1) at 1 kPa.
double response_scale(const std::string& name) {
    const Effect& effect = built_in_effect(name);
    const EffectParameter& p = effect.parameters.front();
    if (p.is_switch()) {
        return 1;
    }
    const EffectValues scale = in_run_units({name, {p.neutral + 5 * p.smallest_of_interest}}, 1000,
                                            {.diameter = 500e-6, .density = 1050});
    const double value = scale.values.front();
    return p.amplitude ? p.amplitude(value) : value - p.neutral;
}

/// Effective amplitude of an effect, to which the response is proportional. It follows from the
/// effect's first parameter and is 0 at the neutral value.
double response_amplitude(const EffectValues& values, double friction) {
    const Effect& effect = built_in_effect(values.effect);
    const EffectParameter& p = effect.parameters.front();
    const double value = values.values.front();
    if (p.effective_amplitude) {
        return p.effective_amplitude(value, friction);
    }
    return p.amplitude ? p.amplitude(value) - p.amplitude(p.neutral) : value - p.neutral;
}

/// Factor to which the response of an observable to an effect is proportional: the effective
/// amplitude, times 1/P* where the effect acts through capillary forces.
double response_size(const EffectValues& values, const FlowState& state, Observable which) {
    const bool with_pressure = domain_of(which) == Domain::all_flow &&
                               built_in_effect(values.effect).fades_with_capillarity;
    return response_amplitude(values, state.friction) *
           (with_pressure ? state.inverse_pressure : 1);
}

/// Amplitude of an effect scaled to the order of 1: divided by its usual range in studies, or by
/// the greatest effective amplitude at this friction.
double response_degree(const EffectValues& values, double friction) {
    const EffectParameter& p = built_in_effect(values.effect).parameters.front();
    const double most = p.effective_amplitude ? p.effective_amplitude(p.upper, friction)
                                              : response_scale(values.effect);
    return most > 0 ? response_amplitude(values, friction) / most : 0;
}

/// Coordinates at which the response to an effect is evaluated, scaled to the range of the studies.
ResponsePlace response_place(const FlowState& state, const EffectValues& values) {
    const Coordinates at = place_of(state);
    ResponsePlace place;
    place << at.x, at.q / 0.1, std::log1p(10 * at.u) / 1.5, state.dry() ? 0.0 : at.v,
        response_degree(values, state.friction);
    return place;
}

}  // namespace

/// Queries that need the response of one observable to one effect.
struct Emulator::Affected {
    const LearnedResponse* learned;
    std::vector<Eigen::Index> queries;
    std::vector<ResponsePlace> places;
    Eigen::VectorXd amplitudes;
    Eigen::VectorXd sizes;  ///< scale of the observable at each query (`emulated::Unit::size`)
};

std::unique_ptr<const Emulator::LearnedResponse> Emulator::learned(const std::string& effect,
                                                                   Observable which) const {
    std::vector<Query> plain;
    std::vector<ResponsePlace> places;
    std::vector<double> amplitudes, training_values, variances, sizes;
    for (const auto& run : runs()) {
        const auto& effects = run.parameters.effects;
        if (effects.size() != 1 || effects[0].effect != effect ||
            !tells(run, which, plain_.structure_stiffness())) {
            continue;
        }
        FlowState state = flow_state_of(run.parameters);
        places.push_back(response_place(state, effects[0]));
        amplitudes.push_back(response_size(effects[0], state, which));
        sizes.push_back(unit_at(which, state).size);
        training_values.push_back(training_value(run, which).value / sizes.back());
        variances.push_back(plain_.noise_variance(run, which) / (sizes.back() * sizes.back()));
        state.effects.clear();
        plain.push_back({state, which});
    }
    if (plain.empty()) {
        throw std::invalid_argument(
            fmt::format("no known run has the effect {}; the atlas that comes with the program has "
                        "such runs: name it in $PENDULAR_ATLAS, or make a campaign with {}",
                        effect, effect));
    }
    const auto vector = [](const std::vector<double>& v) {
        return Eigen::VectorXd(
            Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())));
    };
    const Eigen::VectorXd size = vector(sizes);
    const Eigen::MatrixXd plain_error = size.cwiseInverse().asDiagonal() *
                                        plain_.covariance(plain) * size.cwiseInverse().asDiagonal();
    const Eigen::VectorXd changes =
        vector(training_values) - plain_.mean(plain).cwiseQuotient(size);
    Eigen::MatrixXd covariance = plain_error;
    covariance.diagonal() += vector(variances);
    return std::make_unique<LearnedResponse>(
        LearnedResponse{{std::move(places), vector(amplitudes), changes, covariance},
                        std::move(plain),
                        size,
                        plain_error});
}

const Emulator::LearnedResponse& Emulator::response_to(const std::string& effect,
                                                       Observable which) const {
    Responses::Response* response = nullptr;
    {
        const std::scoped_lock lock(responses_->mutex);
        response = &responses_->all[{effect, which}];
    }
    std::call_once(response->once, [&] { response->learned = learned(effect, which); });
    return *response->learned;
}

std::vector<Emulator::Affected> Emulator::affected(const std::vector<Query>& queries) const {
    std::map<std::pair<std::string, Observable>, Affected> by_response;
    std::map<std::pair<std::string, Observable>, std::vector<std::pair<double, double>>> factors;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const Query& query = queries[k];
        for (const EffectValues& values : query.state.effects) {
            if (query.by) {
                continue;
            }
            const std::pair key(values.effect, query.which);
            Affected& one = by_response[key];
            one.learned = &response_to(values.effect, query.which);
            one.queries.push_back(static_cast<Eigen::Index>(k));
            one.places.push_back(response_place(query.state, values));
            factors[key].emplace_back(response_size(values, query.state, query.which),
                                      unit_at(query.which, query.state).size);
        }
    }
    std::vector<Affected> result;
    for (auto& [key, one] : by_response) {
        const auto n = static_cast<Eigen::Index>(one.queries.size());
        one.amplitudes.resize(n), one.sizes.resize(n);
        for (Eigen::Index k = 0; k < n; ++k) {
            std::tie(one.amplitudes(k), one.sizes(k)) = factors[key][static_cast<std::size_t>(k)];
        }
        result.push_back(std::move(one));
    }
    return result;
}

Eigen::VectorXd Emulator::mean(const std::vector<Query>& queries) const {
    Eigen::VectorXd result = plain_.mean(queries);
    for (const Affected& one : affected(queries)) {
        result(one.queries) +=
            one.sizes.cwiseProduct(one.learned->response.mean(one.places, one.amplitudes));
    }
    return result;
}

Eigen::MatrixXd Emulator::covariance(const std::vector<Query>& queries) const {
    const std::vector<Affected> all = affected(queries);
    const auto n = static_cast<Eigen::Index>(queries.size());
    // The errors of the predictions are linear in those of the predictions without effects at the
    // queries and at the training states of the responses, in this order.
    std::vector<Query> plain = queries;
    for (const Affected& one : all) {
        plain.insert(plain.end(), one.learned->plain.begin(), one.learned->plain.end());
    }
    Eigen::MatrixXd weights_of_training =
        Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(plain.size()) - n);
    Eigen::MatrixXd at_given_plain = Eigen::MatrixXd::Zero(n, n);
    Eigen::Index column = 0;
    for (const Affected& one : all) {
        const auto& [response, trained_at, sizes, plain_error] = *one.learned;
        const Eigen::MatrixXd weights = response.weights(one.places, one.amplitudes);
        weights_of_training(one.queries, Eigen::seqN(column, sizes.size())) =
            -(one.sizes.asDiagonal() * weights * sizes.cwiseInverse().asDiagonal());
        at_given_plain(one.queries, one.queries) +=
            one.sizes.asDiagonal() *
            (response.covariance(one.places, one.amplitudes) -
             weights * plain_error * weights.transpose()) *
            one.sizes.asDiagonal();
        column += sizes.size();
    }
    const Eigen::MatrixXd joint = plain_.covariance(plain);
    if (all.empty()) {
        return joint;
    }
    // (1 W) (A B'; B C) (1 W)' = A + W B + (W B)' + W C W', with W = weights_of_training
    const Eigen::Index trained = column;
    const Eigen::MatrixXd through_training =
        weights_of_training * joint.bottomLeftCorner(trained, n);
    const Eigen::MatrixXd half = weights_of_training * joint.bottomRightCorner(trained, trained);
    return joint.topLeftCorner(n, n) + through_training + through_training.transpose() +
           half * weights_of_training.transpose() + at_given_plain;
}

Emulator Emulator::with(const std::vector<dem::RunResult>& more) const {
    std::vector<dem::RunResult> all = runs();
    all.insert(all.end(), more.begin(), more.end());
    return {all, hyperparameters(), plain_.structure_stiffness()};
}

std::string Emulator::beyond(const FlowState& state) const {
    struct Known {
        const char* name;
        double value, least = INFINITY, greatest = -INFINITY;
        bool below_smallest_of_interest = true;
    };
    std::vector<Known> inputs = {{.name = "friction", .value = state.friction},
                                 {.name = "inertial number",
                                  .value = state.inertial_number,
                                  .below_smallest_of_interest = false}};
    if (!state.dry()) {
        inputs.push_back({.name = "reduced pressure", .value = 1 / state.inverse_pressure});
        inputs.push_back({.name = "bridge volume over a^3", .value = state.bridge_volume});
    }
    for (const auto& run : runs()) {
        const auto& p = run.parameters;
        if (state.dry() || p.wetting) {
            double values[] = {p.friction, p.inertial_number, 0, 0};
            if (p.wetting) {
                values[2] = p.wetting->reduced_pressure;
                values[3] = p.wetting->bridge_volume;
            }
            for (std::size_t k = 0; k < inputs.size(); ++k) {
                inputs[k].least = std::min(inputs[k].least, values[k]);
                inputs[k].greatest = std::max(inputs[k].greatest, values[k]);
            }
        }
    }
    constexpr double rounding = 1e-6;
    std::string text;
    for (const Known& input : inputs) {
        const bool above = input.value > input.greatest * (1 + rounding);
        if (above ||
            (input.below_smallest_of_interest && input.value < input.least * (1 - rounding))) {
            text += fmt::format("{}{} {:.4g} is {} {:.4g}", text.empty() ? "" : ", ", input.name,
                                input.value, above ? "above" : "below",
                                above ? input.greatest : input.least);
        }
    }
    return text;
}

}  // namespace pendular
