#include "calib/emulator/plain_emulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/gaussian_process.h"

namespace pendular {

using dem::Observable;
using namespace emulated;

namespace {

/// Whether a run trains the process of an observable for grains of about this stiffness number: it
/// has no effects and a value of the observable.
bool teaches(const dem::RunResult& run, Observable which, double stiffness_number) {
    return run.parameters.effects.empty() && has_value(run, which) &&
           alike(run.parameters.stiffness_number, stiffness_number);
}

/// Returns `wanted` where a run without effects has about this stiffness number, else the stiffness
/// number of the first run without effects.
double stiffness_number_of(const std::vector<dem::RunResult>& runs, double wanted) {
    const auto plain = [](const dem::RunResult& run) { return run.parameters.effects.empty(); };
    const auto wanted_one = [&](const dem::RunResult& run) {
        return plain(run) && alike(run.parameters.stiffness_number, wanted);
    };
    const auto first = std::ranges::find_if(runs, plain);
    return first == runs.end() || std::ranges::any_of(runs, wanted_one)
               ? wanted
               : first->parameters.stiffness_number;
}

/// Observable under which the process of this observable is stored: stress ratio and solid fraction
/// share one process.
Observable process_for(Observable which) {
    return in_pair(which) ? pair[0] : which;
}

/// Training observations for the process of an observable: of this observable alone, or of stress
/// ratio and solid fraction together.
Observations observations_of(const std::vector<dem::RunResult>& runs, Observable which,
                             double stiffness_number) {
    std::vector<Observable> quantities = {which};
    if (in_pair(which)) {
        quantities.assign(std::begin(pair), std::end(pair));
    }
    const auto m = static_cast<Eigen::Index>(quantities.size());
    Observations known;
    std::vector<double> values;
    for (const auto& run : runs) {
        if (!teaches(run, which, stiffness_number)) {
            continue;
        }
        const FlowState state = flow_state_of(run.parameters);
        const Unit unit = unit_at(which, state);
        known.at.push_back(place_of(state));
        Eigen::MatrixXd noise(m, m);
        for (Eigen::Index k = 0; k < m; ++k) {
            const Mean mean = training_value(run, quantities[static_cast<std::size_t>(k)]);
            values.push_back((mean.value - unit.offset) / unit.size);
            noise(k, k) = std::pow(mean.standard_error / unit.size, 2);
        }
        if (m == 2) {
            noise(0, 1) = noise(1, 0) = run.covariance;
        }
        known.noise.push_back(noise);
    }
    if (known.at.empty()) {
        throw std::invalid_argument(
            fmt::format("no simulation that trains the emulator has a value of {}",
                        dem::observable_names[static_cast<std::size_t>(which)]));
    }
    known.values = Eigen::MatrixXd(
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            values.data(), static_cast<Eigen::Index>(known.at.size()), m));
    // Even a run that states no error, since nothing varied, is not exact. Relative to the mean;
    // the solid fraction, the most precise average, has errors from 0.0001 on (docs/validation.md).
    constexpr double least_error = 1e-4;
    const Eigen::RowVectorXd means = known.values.cwiseAbs().colwise().mean();
    for (auto& noise : known.noise) {
        noise.diagonal() += (least_error * means.transpose()).cwiseAbs2();
    }
    return known;
}

double unit_of(const Observations& known, Eigen::Index quantity) {
    return std::sqrt(known.values.col(quantity).squaredNorm() /
                     static_cast<double>(known.at.size()));
}

/// One term of a query that is written as a weighted sum of values that a process predicts.
struct Term {
    double factor = 1;
    GaussianProcess::Requested requested;
};

std::vector<Term> terms_of(const Query& query) {
    if (of_bridges(query.which) && query.state.dry()) {
        throw std::invalid_argument(fmt::format(
            "dry grains have no {}", dem::observable_names[static_cast<std::size_t>(query.which)]));
    }
    const Coordinates at = place_of(query.state);
    const Eigen::Index quantity = query.which == pair[1];
    const Unit unit = unit_at(query.which, query.state);
    const auto of_process = [&](double factor, int derivative) {
        return Term{factor, {quantity, {at, derivative}}};
    };
    if (!query.by) {
        return {of_process(unit.size, Functional::value)};
    }
    switch (*query.by) {
        case Input::friction:
            return {of_process(unit.size / (query.state.friction + friction_scale), 0)};
        case Input::log_inertial_number:
            return {of_process(unit.size * exponent * at.q, 1)};
        case Input::inverse_pressure:
            return {of_process(unit.size, 2),
                    of_process(unit.by_inverse_pressure, Functional::value)};
        default:
            return {of_process(query.state.dry() ? 0 : unit.size / query.state.bridge_volume, 3),
                    of_process(unit.by_bridge_volume, Functional::value)};
    }
}

/// Queries that one process answers: their indices, the values that the process must predict, and
/// the linear map from these values to the answers.
struct Share {
    std::vector<Eigen::Index> queries;
    std::vector<GaussianProcess::Requested> requested;
    Eigen::SparseMatrix<double> map;
};

std::map<Observable, Share> shares_of(const std::vector<Query>& queries) {
    std::map<Observable, Share> shares;
    std::map<Observable, std::vector<std::vector<Term>>> terms;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const Observable process = process_for(queries[k].which);
        shares[process].queries.push_back(static_cast<Eigen::Index>(k));
        terms[process].push_back(terms_of(queries[k]));
    }
    for (auto& [process, share] : shares) {
        std::vector<Eigen::Triplet<double>> factors;
        for (std::size_t row = 0; row < terms[process].size(); ++row) {
            for (const Term& term : terms[process][row]) {
                factors.emplace_back(static_cast<int>(row),
                                     static_cast<int>(share.requested.size()), term.factor);
                share.requested.push_back(term.requested);
            }
        }
        share.map.resize(std::ssize(terms[process]), std::ssize(share.requested));
        share.map.setFromTriplets(factors.begin(), factors.end());
    }
    return shares;
}

}  // namespace

double PlainEmulator::noise_variance(const dem::RunResult& run, Observable which) const {
    const Hyperparameters hyperparameters = hyperparameters_of(which);
    const double size = unit_at(which, flow_state_of(run.parameters)).size;
    return hyperparameters.noise * std::pow(training_value(run, which).standard_error, 2) +
           std::pow(hyperparameters.between_run_scatter * size, 2);
}

Eigen::Matrix2d PlainEmulator::noise(const dem::RunResult& run) const {
    Eigen::Matrix2d noise;
    noise.diagonal() << noise_variance(run, pair[0]), noise_variance(run, pair[1]);
    noise(0, 1) = noise(1, 0) = run.covariance * std::sqrt(hyperparameters_of(pair[0]).noise *
                                                           hyperparameters_of(pair[1]).noise);
    return noise;
}

bool PlainEmulator::known(const std::vector<dem::RunResult>& runs, Observable which) {
    const double stiffness_number = stiffness_number_of(runs, reference_stiffness);
    return std::ranges::any_of(
        runs, [&](const auto& run) { return teaches(run, which, stiffness_number); });
}

Hyperparameters PlainEmulator::learn(const std::vector<dem::RunResult>& runs, Observable which,
                                     double stiffness_number) {
    const Observations known =
        observations_of(runs, which, stiffness_number_of(runs, stiffness_number));
    const Eigen::Index quantity = which == pair[1];
    return fit_hyperparameters(domain_of(which), known.only(quantity), unit_of(known, quantity));
}

PlainEmulator::PlainEmulator(const std::vector<dem::RunResult>& runs,
                             EmulatorHyperparameters hyperparameters, double stiffness_number)
    : stiffness_number_(stiffness_number), learned_(std::make_unique<Learned>()) {
    learned_->hyperparameters = std::move(hyperparameters);
    std::ranges::copy_if(runs, std::back_inserter(runs_), usable);
    if (runs_.empty()) {
        throw std::invalid_argument("there is no simulation to train the emulator on");
    }
    stiffness_number_ = stiffness_number_of(runs_, stiffness_number);
}

EmulatorHyperparameters PlainEmulator::hyperparameters() const {
    const std::scoped_lock lock(learned_->mutex);
    return learned_->hyperparameters;
}

Hyperparameters PlainEmulator::hyperparameters_of(Observable which) const {
    {
        const std::scoped_lock lock(learned_->mutex);
        const auto known = learned_->hyperparameters.find(which);
        if (known != learned_->hyperparameters.end()) return known->second;
    }
    const Hyperparameters hyperparameters = learn(runs_, which, stiffness_number_);
    const std::scoped_lock lock(learned_->mutex);
    return learned_->hyperparameters.emplace(which, hyperparameters).first->second;
}

std::unique_ptr<const GaussianProcess> PlainEmulator::trained(Observable which) const {
    const Observations known = observations_of(runs_, which, stiffness_number_);
    std::vector<Observable> quantities = {which};
    if (in_pair(which)) {
        quantities.assign(std::begin(pair), std::end(pair));
    }
    std::vector<Kernel> kernels;
    for (const Observable quantity : quantities) {
        kernels.emplace_back(domain_of(quantity), hyperparameters_of(quantity),
                             unit_of(known, static_cast<Eigen::Index>(kernels.size())));
    }
    return std::make_unique<GaussianProcess>(std::move(kernels), known);
}

const GaussianProcess& PlainEmulator::process_of(Observable which) const {
    Learned::Process& process = learned_->processes[static_cast<std::size_t>(process_for(which))];
    std::call_once(process.once, [&] { process.trained = trained(process_for(which)); });
    return *process.trained;
}

Eigen::VectorXd PlainEmulator::mean(const std::vector<Query>& queries) const {
    Eigen::VectorXd result(static_cast<Eigen::Index>(queries.size()));
    for (const auto& [process, share] : shares_of(queries)) {
        result(share.queries) = share.map * process_of(process).mean(share.requested);
    }
    for (std::size_t k = 0; k < queries.size(); ++k) {
        if (!queries[k].by) {
            result(static_cast<Eigen::Index>(k)) +=
                unit_at(queries[k].which, queries[k].state).offset;
        }
    }
    return result;
}

PlainEmulator::PreparedQueries PlainEmulator::prepare(const std::vector<Query>& queries) const {
    PreparedQueries prepared{.count = std::ssize(queries), .shares = {}};
    for (auto& [process, share] : shares_of(queries)) {
        prepared.shares[process] = {std::move(share.queries),
                                    process_of(process).solve(std::move(share.requested)),
                                    std::move(share.map)};
    }
    return prepared;
}

Eigen::MatrixXd PlainEmulator::covariance(const PreparedQueries& queries) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(queries.count, queries.count);
    for (const auto& [process, share] : queries.shares) {
        const Eigen::MatrixXd half = share.map * process_of(process).covariance_of(share.values);
        result(share.queries, share.queries) = half * share.map.transpose();
    }
    return result;
}

Eigen::MatrixXd PlainEmulator::covariance(const PreparedQueries& a,
                                          const PreparedQueries& b) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(a.count, b.count);
    for (const auto& [process, share] : a.shares) {
        const auto other = b.shares.find(process);
        if (other == b.shares.end()) continue;
        const Eigen::MatrixXd half =
            share.map * process_of(process).covariance_between(share.values, other->second.values);
        result(share.queries, other->second.queries) = half * other->second.map.transpose();
    }
    return result;
}

}  // namespace pendular
