#include "calib/emulator/emulator.h"

#include <fmt/format.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "sim/catalogue/effect.h"

namespace pendular {

using dem::Observable;
using namespace emulated;

namespace {

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& values) {
    return {values.data(), static_cast<Eigen::Index>(values.size())};
}

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

/// Whether models of studies can have an effect with these values: parameters that only simulations
/// have are neutral.
bool in_models(const EffectValues& values) {
    const auto& parameters = built_in_effect(values.effect).parameters;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        if (parameters[k].only_simulated && values.values[k] != parameters[k].neutral) return false;
    }
    return true;
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

/// Amplitude of the change from one stiffness number to another [1]: their difference in overlap,
/// which goes as 1/(stiffness number), over the overlap at the first. It is 1 for rigid grains. No
/// grains softer than half the first stiffness number train the response, so that the amplitude
/// ends there, at -1.
double stiffness_change(double from, double to) {
    return std::max(-1.0, 1 - from / to);
}

/// Coordinates at which the response to a cause of this amplitude (`degree`) is evaluated, scaled
/// to the range of the studies.
ResponsePlace response_place(const FlowState& state, double degree) {
    const Coordinates at = place_of(state);
    ResponsePlace place;
    place << at.x, at.q / 0.1, std::log1p(10 * at.u) / 1.5, state.dry() ? 0.0 : at.v, degree;
    return place;
}

/// Step of a variable for central differences of responses, which are smooth over the scale of
/// each coordinate.
double step_of(const FlowState& state, Input variable) {
    constexpr double relative = 1e-3;  // the error of the quotient goes as its square
    switch (variable) {
        case Input::friction:
            return relative * (state.friction + friction_scale);
        case Input::inverse_pressure:
            return relative * (state.inverse_pressure + 0.1);
        case Input::bridge_volume:
            return relative * state.bridge_volume;
        default:
            return relative;
    }
}

FlowState shifted(FlowState state, Input variable, double by) {
    switch (variable) {
        case Input::friction:
            state.friction += by;
            break;
        case Input::inverse_pressure:
            state.inverse_pressure += by;
            break;
        case Input::bridge_volume:
            state.bridge_volume += by;
            break;
        default:
            state.inertial_number *= std::exp(by);
    }
    return state;
}

/// States whose responses, multiplied by the numbers beside them, add up to that of a query: its
/// own state for a value, two states for a derivative, by central differences.
std::vector<std::pair<FlowState, double>> states_of(const Query& query) {
    if (!query.by) return {{query.state, 1}};
    if (query.state.dry() && *query.by != Input::friction &&
        *query.by != Input::log_inertial_number) {
        return {};
    }
    const double step = step_of(query.state, *query.by);
    return {{shifted(query.state, *query.by, step), 1 / (2 * step)},
            {shifted(query.state, *query.by, -step), -1 / (2 * step)}};
}

}  // namespace

Emulator::Emulator(const std::vector<dem::RunResult>& runs, EmulatorHyperparameters hyperparameters,
                   double stiffness_number)
    : plain_(runs, std::move(hyperparameters), stiffness_number) {
    knows_stiffness_ = std::ranges::any_of(plain_.runs(), [&](const dem::RunResult& run) {
        return trains(run, stiffness_name, Observable::stress_ratio);
    });
}

template <typename Use>
void Emulator::each_cause(const FlowState& state, Observable which, const Use& use) const {
    for (const EffectValues& values : state.effects) {
        use(values.effect, response_size(values, state, which),
            response_place(state, response_degree(values, state.friction)));
    }
    if (stiffened(state)) {
        const double change = stiffness_change(plain_.stiffness_number(), state.stiffness_number);
        use(stiffness_name, change, response_place(state, change));
    }
}

bool Emulator::stiffened(const FlowState& state) const {
    return knows_stiffness_ && state.stiffness_number > 0 &&
           state.stiffness_number != plain_.stiffness_number();
}

bool Emulator::trains(const dem::RunResult& run, const std::string& name, Observable which) const {
    const auto& effects = run.parameters.effects;
    const bool caused =
        name == stiffness_name
            ? effects.empty() && !alike(run.parameters.stiffness_number, plain_.stiffness_number())
            : effects.size() == 1 && effects[0].effect == name && in_models(effects[0]);
    return caused && has_value(run, which);
}

/// Evaluations of the response of one observable to one cause that queries need.
struct Emulator::Affected {
    std::string cause;
    Observable which;
    const LearnedResponse* learned;
    std::vector<Eigen::Index> queries = {};  ///< query that needs each evaluation
    std::vector<double> factors = {};        ///< change of its answer per response
    std::vector<ResponsePlace> places = {};  ///< coordinates of each evaluation
    std::vector<double> amplitudes = {};     ///< amplitude of the cause there

    /// Linear map from the responses to the changes of the answers to `count` queries.
    Eigen::SparseMatrix<double> map(std::size_t count) const {
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            entries.emplace_back(queries[k], k, factors[k]);
        }
        Eigen::SparseMatrix<double> result(static_cast<Eigen::Index>(count), std::ssize(queries));
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    }
};

std::unique_ptr<const Emulator::LearnedResponse> Emulator::learned(const std::string& name,
                                                                   Observable which) const {
    std::vector<ResponsePlace> places;
    std::vector<double> sizes_of_cause, training_values, variances, sizes;
    std::vector<Query> plain, of_own_stiffness;
    for (const auto& run : runs()) {
        if (!trains(run, name, which)) continue;
        FlowState state = flow_state_of(run.parameters);
        // An effect at another stiffness number has two causes, and this one is the effect's.
        if (name != stiffness_name) state.stiffness_number = 0;
        each_cause(state, which, [&](const std::string&, double size, const ResponsePlace& place) {
            places.push_back(place);
            sizes_of_cause.push_back(size);
        });
        state.stiffness_number = run.parameters.stiffness_number;
        sizes.push_back(unit_at(which, state).size);
        training_values.push_back(training_value(run, which).value / sizes.back());
        variances.push_back(plain_.noise_variance(run, which) / (sizes.back() * sizes.back()));
        state.effects.clear();
        if (name == stiffness_name) state.stiffness_number = 0;
        of_own_stiffness.push_back({state, which});
        state.stiffness_number = 0;
        plain.push_back({state, which});
    }
    if (plain.empty()) {
        throw std::invalid_argument(fmt::format(
            "no simulation in atlas and store has the effect {}; the atlas that comes with the "
            "program has such simulations: name it in $PENDULAR_ATLAS, or make a campaign with {}",
            name, name));
    }
    const Eigen::VectorXd size = as_vector(sizes);
    // Runs with an effect differ from predictions without it at their own stiffness number.
    const auto error_at = [&](const Eigen::MatrixXd& covariance) {
        return Eigen::MatrixXd(size.cwiseInverse().asDiagonal() * covariance *
                               size.cwiseInverse().asDiagonal());
    };
    PlainEmulator::PreparedQueries prepared = plain_.prepare(plain);
    const Eigen::MatrixXd plain_error = error_at(plain_.covariance(prepared));
    const Eigen::VectorXd changes =
        as_vector(training_values) - mean(of_own_stiffness).cwiseQuotient(size);
    Eigen::MatrixXd training_error = error_at(covariance(of_own_stiffness));
    training_error.diagonal() += as_vector(variances);
    return std::make_unique<LearnedResponse>(
        LearnedResponse{{std::move(places), as_vector(sizes_of_cause), changes, training_error},
                        std::move(prepared),
                        size,
                        plain_error});
}

const Emulator::LearnedResponse& Emulator::response_to(const std::string& name,
                                                       Observable which) const {
    Responses::Response* response = nullptr;
    {
        const std::scoped_lock lock(responses_->mutex);
        response = &responses_->all[{name, which}];
    }
    std::call_once(response->once, [&] { response->learned = learned(name, which); });
    return *response->learned;
}

bool Emulator::knows(const std::string& name) const {
    return std::ranges::any_of(runs(), [&](const dem::RunResult& run) {
        return trains(run, name, Observable::stress_ratio);
    });
}

std::vector<Emulator::Affected> Emulator::affected(const std::vector<Query>& queries) const {
    std::vector<Affected> result;
    const auto response = [&](const std::string& cause, Observable which) -> Affected& {
        const auto known = std::ranges::find_if(
            result, [&](const Affected& one) { return one.which == which && one.cause == cause; });
        if (known != result.end()) return *known;
        return result.emplace_back(Affected{cause, which, &response_to(cause, which)});
    };
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const Query& query = queries[k];
        const auto evaluate = [&](const FlowState& state, double weight) {
            const double factor = weight * unit_at(query.which, state).size;
            each_cause(state, query.which,
                       [&](const std::string& name, double size, const ResponsePlace& place) {
                           if (query.by && name != stiffness_name) return;
                           Affected& one = response(name, query.which);
                           one.queries.push_back(static_cast<Eigen::Index>(k));
                           one.factors.push_back(factor);
                           one.places.push_back(place);
                           one.amplitudes.push_back(size);
                       });
        };
        if (!query.by) {
            evaluate(query.state, 1);
        } else if (stiffened(query.state)) {
            for (const auto& [state, weight] : states_of(query)) {
                evaluate(state, weight);
            }
        }
    }
    return result;
}

bool Emulator::changes(const FlowState& state) const {
    return !state.effects.empty() || stiffened(state);
}

Eigen::VectorXd Emulator::mean(const std::vector<Query>& queries) const {
    return plain_.mean(queries) + changes_by_causes(queries);
}

Eigen::VectorXd Emulator::changes_by_causes(const std::vector<Query>& queries) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(std::ssize(queries));
    for (const Affected& one : affected(queries)) {
        const Eigen::VectorXd responses =
            one.learned->response.mean(one.places, as_vector(one.amplitudes));
        for (std::size_t k = 0; k < one.queries.size(); ++k) {
            result(one.queries[k]) += one.factors[k] * responses(static_cast<Eigen::Index>(k));
        }
    }
    return result;
}

Eigen::MatrixXd Emulator::covariance(const std::vector<Query>& queries) const {
    const std::vector<Affected> all = affected(queries);
    const PlainEmulator::PreparedQueries asked = plain_.prepare(queries);
    // The errors of the predictions are linear in those of the predictions without effects at the
    // queries and, with weights W, at the training states of the responses:
    //     (1 W) (A B'; B C) (1 W)' = A + W B + (W B)' + W C W'
    Eigen::MatrixXd result = plain_.covariance(asked);
    std::vector<Eigen::MatrixXd> weights_of_training;
    for (const Affected& one : all) {
        const LearnedResponse& learned = *one.learned;
        const Eigen::VectorXd amplitudes = as_vector(one.amplitudes);
        const Eigen::MatrixXd weights = learned.response.weights(one.places, amplitudes);
        const Eigen::SparseMatrix<double> map = one.map(queries.size());
        result += map *
                  (learned.response.covariance(one.places, amplitudes) -
                   weights * learned.plain_error * weights.transpose()) *
                  map.transpose();
        weights_of_training.push_back(-(map * weights * learned.sizes.cwiseInverse().asDiagonal()));
        const Eigen::MatrixXd through_training =
            weights_of_training.back() * plain_.covariance(learned.plain, asked);
        result += through_training + through_training.transpose();
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const Eigen::MatrixXd& training = training_covariance(*all[i].learned, *all[j].learned);
            if (training.size() == 0) continue;
            const Eigen::MatrixXd part =
                weights_of_training[i] * training * weights_of_training[j].transpose();
            result += part;
            if (j < i) result += part.transpose();
        }
    }
    return result;
}

const Eigen::MatrixXd& Emulator::training_covariance(const LearnedResponse& a,
                                                     const LearnedResponse& b) const {
    const std::scoped_lock lock(responses_->mutex);
    const auto [known, added] = responses_->training_covariances.try_emplace({&a, &b});
    const bool dependent = std::ranges::any_of(
        a.plain.shares, [&](const auto& share) { return b.plain.shares.contains(share.first); });
    if (added && dependent) known->second = plain_.covariance(a.plain, b.plain);
    return known->second;
}

Emulator Emulator::with(const std::vector<dem::RunResult>& more) const {
    std::vector<dem::RunResult> all = runs();
    all.insert(all.end(), more.begin(), more.end());
    return {all, hyperparameters(), plain_.stiffness_number()};
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
    constexpr double rounding = 1e-6;  // of the conversion from stresses and contents
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
