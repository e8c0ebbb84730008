// What effects on grains add to what the emulator says of beads without.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <tuple>

#include "calib/emulated_observables.h"
#include "sim/effect.h"

namespace pendular {

using dem::Observable;
using namespace emulated;

namespace {

/// How large the amplitude of an effect comes in studies; in the units of a run at 1 kPa.
double response_scale(const std::string& name) {
    const Effect& effect = built_in_effect(name);
    const EffectParameter& p = effect.parameters.front();
    if (p.is_switch()) {
        return 1;
    }
    const EffectValues scale = in_run_units({name, {p.neutral + 5 * p.matters}}, 1000,
                                            {.diameter = 500e-6, .density = 1050});
    const double value = scale.values.front();
    return p.amplitude ? p.amplitude(value) : value - p.neutral;
}

/// The amplitude with which an effect grows in proportion, as far as friction lets it be felt, 0 at
/// neutral; that of the first parameter.
double response_amplitude(const EffectValues& values, double friction) {
    const Effect& effect = built_in_effect(values.effect);
    const EffectParameter& p = effect.parameters.front();
    const double value = values.values.front();
    if (p.felt) {
        return p.felt(value, friction);
    }
    return p.amplitude ? p.amplitude(value) - p.amplitude(p.neutral) : value - p.neutral;
}

/// Whether an effect changes what capillary forces do, and so fades with them. One that adds forces
/// of its own between wet beads, as viscosity, does not.
bool fades(const Effect& effect) {
    const auto* pairs = std::get_if<dem::ChangePairs>(&effect.change);
    return effect.touches == Touches::wet && pairs != nullptr && pairs->add == nullptr;
}

/// What the response of an observable to an effect goes in proportion to.
double response_size(const EffectValues& values, const FlowState& state, Observable which) {
    const bool with_pressure =
        domain_of(which) == Domain::all_flow && fades(built_in_effect(values.effect));
    return response_amplitude(values, state.friction) *
           (with_pressure ? state.inverse_pressure : 1);
}

/// How far an effect goes, of the order of 1: over what it comes to in studies, or over what
/// friction lets it be at most.
double response_degree(const EffectValues& values, double friction) {
    const EffectParameter& p = built_in_effect(values.effect).parameters.front();
    const double most = p.felt ? p.felt(p.upper, friction) : response_scale(values.effect);
    return most > 0 ? response_amplitude(values, friction) / most : 0;
}

/// Where the response to an effect is asked; widths are those of the studies' range.
ResponsePlace response_place(const FlowState& state, const EffectValues& values) {
    const Coordinates at = place_of(state);
    ResponsePlace place;
    place << at.x, at.q / 0.1, std::log1p(10 * at.u) / 1.5, state.dry() ? 0.0 : at.v,
        response_degree(values, state.friction);
    return place;
}

}  // namespace

/// Queries that one response answers.
struct Emulator::Affected {
    const EffectResponse* response;
    std::vector<Eigen::Index> queries;
    std::vector<ResponsePlace> places;
    Eigen::VectorXd amplitudes;
    Eigen::VectorXd sizes;  ///< of the observable's unit
};

EffectResponse Emulator::learn_response(const std::string& effect, Observable which) const {
    std::vector<Query> plain;
    std::vector<ResponsePlace> places;
    std::vector<double> amplitudes, told, variances, sizes;
    for (const auto& run : runs_) {
        const auto& effects = run.parameters.effects;
        if (effects.size() != 1 || effects[0].effect != effect || !tells(run, which)) {
            continue;
        }
        FlowState state = state_of(run.parameters);
        places.push_back(response_place(state, effects[0]));
        amplitudes.push_back(response_size(effects[0], state, which));
        sizes.push_back(unit_at(which, state).size);
        told.push_back(taught(run, which).value / sizes.back());
        variances.push_back(noise_variance(run, which) / (sizes.back() * sizes.back()));
        state.effects.clear();
        plain.push_back({state, which});
    }
    if (plain.empty()) {
        throw std::invalid_argument(fmt::format(
            "no known run has the effect {}; the atlas that comes with the program has some: name "
            "it with $PENDULAR_ATLAS, or make a campaign with {} in it",
            effect, effect));
    }
    const auto vector = [](const std::vector<double>& v) {
        return Eigen::VectorXd(
            Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())));
    };
    const Eigen::VectorXd size = vector(sizes);
    Eigen::MatrixXd covariance = size.cwiseInverse().asDiagonal() * plain_covariance(plain) *
                                 size.cwiseInverse().asDiagonal();
    covariance.diagonal() += vector(variances);
    return {std::move(places), vector(amplitudes),
            vector(told) - plain_mean(plain).cwiseQuotient(size), covariance};
}

const EffectResponse& Emulator::response_to(const std::string& effect, Observable which) const {
    const std::pair key(effect, which);
    auto found = responses_.find(key);
    if (found == responses_.end()) {
        found = responses_.emplace(key, learn_response(effect, which)).first;
    }
    return found->second;
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
            one.response = &response_to(values.effect, query.which);
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
    Eigen::VectorXd result = plain_mean(queries);
    for (const Affected& one : affected(queries)) {
        result(one.queries) +=
            one.sizes.cwiseProduct(one.response->mean(one.places, one.amplitudes));
    }
    return result;
}

Eigen::MatrixXd Emulator::covariance(const std::vector<Query>& queries) const {
    Eigen::MatrixXd result = plain_covariance(queries);
    for (const Affected& one : affected(queries)) {
        result(one.queries, one.queries) += one.sizes.asDiagonal() *
                                            one.response->covariance(one.places, one.amplitudes) *
                                            one.sizes.asDiagonal();
    }
    return result;
}

}  // namespace pendular
