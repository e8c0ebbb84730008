#include "calib/emulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "calib/emulated_observables.h"

namespace pendular {

using dem::Observable;
using namespace emulated;

namespace {

/// Softer beads overlap more than the correction to rigid ones was measured for.
constexpr double softest = 300;

/// Whether it says something of beads without effects.
bool teaches(const dem::RunResult& run, Observable which) {
    return run.parameters.effects.empty() && tells(run, which);
}

/// The observable under whose name the process stands that answers for this one.
Observable process_for(Observable which) {
    return in_pair(which) ? pair[0] : which;
}

/// What the process of an observable knows: of the pair, both.
Observations observations_of(const std::vector<dem::RunResult>& runs, Observable which) {
    std::vector<Observable> quantities = {which};
    if (in_pair(which)) {
        quantities.assign(std::begin(pair), std::end(pair));
    }
    const auto m = static_cast<Eigen::Index>(quantities.size());
    Observations known;
    std::vector<double> values;
    for (const auto& run : runs) {
        if (!teaches(run, which)) {
            continue;
        }
        const FlowState state = Emulator::state_of(run.parameters);
        const Unit unit = unit_at(which, state);
        known.at.push_back(place_of(state));
        Eigen::MatrixXd noise(m, m);
        for (Eigen::Index k = 0; k < m; ++k) {
            const Mean mean = Emulator::taught(run, quantities[static_cast<std::size_t>(k)]);
            values.push_back((mean.value - unit.offset) / unit.size);
            noise(k, k) = std::pow(mean.standard_error / unit.size, 2);
        }
        if (m == 2) {
            noise(0, 1) = noise(1, 0) = run.covariance;
        }
        known.noise.push_back(noise);
    }
    if (known.at.empty()) {
        throw std::invalid_argument(fmt::format(
            "no run says anything of {}", dem::observable_names[static_cast<std::size_t>(which)]));
    }
    known.values = Eigen::MatrixXd(
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            values.data(), static_cast<Eigen::Index>(known.at.size()), m));
    // A run that states no error, as where nothing varies, still is not exact.
    constexpr double least_error = 1e-4;
    const Eigen::RowVectorXd sizes = known.values.cwiseAbs().colwise().mean();
    for (auto& noise : known.noise) {
        noise.diagonal() += (least_error * sizes.transpose()).cwiseAbs2();
    }
    return known;
}

double unit_of(const Observations& known, Eigen::Index quantity) {
    return std::sqrt(known.values.col(quantity).squaredNorm() /
                     static_cast<double>(known.at.size()));
}

/// A query is a sum of what a process can be asked, each with a factor.
struct Term {
    double factor = 1;
    GaussianProcess::Asked asked;
};

std::vector<Term> terms_of(const Query& query) {
    if (Emulator::of_bridges(query.which) && query.state.dry()) {
        throw std::invalid_argument(fmt::format(
            "dry beads have no {}", dem::observable_names[static_cast<std::size_t>(query.which)]));
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

/// The queries that one process answers: their places in the list, all they ask, and the map from
/// those answers to the queries'.
struct Share {
    std::vector<Eigen::Index> queries;
    std::vector<GaussianProcess::Asked> asked;
    Eigen::MatrixXd map;
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
        std::vector<double> factors;
        std::vector<Eigen::Index> rows;
        for (std::size_t row = 0; row < terms[process].size(); ++row) {
            for (const Term& term : terms[process][row]) {
                share.asked.push_back(term.asked);
                factors.push_back(term.factor);
                rows.push_back(static_cast<Eigen::Index>(row));
            }
        }
        const auto columns = static_cast<Eigen::Index>(factors.size());
        share.map =
            Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(terms[process].size()), columns);
        for (Eigen::Index c = 0; c < columns; ++c) {
            share.map(rows[static_cast<std::size_t>(c)], c) = factors[static_cast<std::size_t>(c)];
        }
    }
    return shares;
}

}  // namespace

bool Emulator::of_bridges(Observable which) {
    // Z* counts distant bridges, which are there however little they matter, and none in dry flow.
    return dem::needs_bridges(which) || which == Observable::effective_coordination;
}

bool Emulator::usable(const dem::RunResult& run) {
    return run.failure.empty() && !run.crystallised && run.steady &&
           run.parameters.damping == dem::RunParameters{}.damping &&
           run.parameters.stiffness_number >= softest;
}

FlowState Emulator::state_of(const dem::RunParameters& p) {
    FlowState state{p.friction, p.inertial_number};
    if (p.wetting) {
        state.inverse_pressure = 1 / p.wetting->reduced_pressure;
        state.bridge_volume = p.wetting->bridge_volume;
    }
    state.effects = p.effects;
    return state;
}

Mean Emulator::taught(const dem::RunResult& run, Observable which) {
    Mean mean = run[which];
    if (which == Observable::solid_fraction) {
        mean.value -= dem::rigidity_shift(mean.value, run[Observable::mean_overlap].value);
    } else if (which == Observable::mean_overlap) {
        const double factor = run.parameters.stiffness_number / reference_stiffness;
        mean.value *= factor;
        mean.standard_error *= factor;
    }
    return mean;
}

double Emulator::noise_variance(const dem::RunResult& run, Observable which) const {
    process_of(which);  // learns what is missing
    const Scales& scales = scales_.at(which);
    const double size = unit_at(which, state_of(run.parameters)).size;
    return scales.noise * std::pow(taught(run, which).standard_error, 2) +
           std::pow(scales.between * size, 2);
}

Eigen::Matrix2d Emulator::noise(const dem::RunResult& run) const {
    Eigen::Matrix2d noise;
    noise.diagonal() << noise_variance(run, pair[0]), noise_variance(run, pair[1]);
    noise(0, 1) = noise(1, 0) =
        run.covariance * std::sqrt(scales_.at(pair[0]).noise * scales_.at(pair[1]).noise);
    return noise;
}

const std::vector<Observable>& Emulator::observables() {
    // But for what a run imposes, what tells that it crystallised, and the parts of the work.
    static const std::vector<Observable> all = [] {
        using enum Observable;
        std::vector<Observable> emulated;
        for (std::size_t k = 0; k < dem::observable_count; ++k) {
            const auto which = static_cast<Observable>(k);
            if (which < dissipation_friction && which != held_normal_stress &&
                which != bond_order) {
                emulated.push_back(which);
            }
        }
        return emulated;
    }();
    return all;
}

bool Emulator::known(const std::vector<dem::RunResult>& runs, Observable which) {
    return std::ranges::any_of(runs, [&](const auto& run) { return teaches(run, which); });
}

Scales Emulator::learn(const std::vector<dem::RunResult>& runs, Observable which) {
    const Observations known = observations_of(runs, which);
    const Eigen::Index quantity = which == pair[1];
    return learn_scales(domain_of(which), known.only(quantity), unit_of(known, quantity));
}

Emulator::Emulator(const std::vector<dem::RunResult>& runs, EmulatorScales scales)
    : scales_(std::move(scales)) {
    std::ranges::copy_if(runs, std::back_inserter(runs_), usable);
    if (runs_.empty()) {
        throw std::invalid_argument("there is no run to learn from");
    }
}

Emulator::~Emulator() = default;
Emulator::Emulator(Emulator&&) noexcept = default;
Emulator& Emulator::operator=(Emulator&&) noexcept = default;

Emulator Emulator::with(const std::vector<dem::RunResult>& more) const {
    std::vector<dem::RunResult> all = runs_;
    all.insert(all.end(), more.begin(), more.end());
    return {all, scales_};
}

const GaussianProcess& Emulator::process_of(Observable which) const {
    auto& process = processes_[process_for(which)];
    if (!process) {
        const Observations known = observations_of(runs_, which);
        std::vector<Observable> quantities = {which};
        if (in_pair(which)) {
            quantities.assign(std::begin(pair), std::end(pair));
        }
        std::vector<Kernel> kernels;
        for (const Observable quantity : quantities) {
            if (!scales_.contains(quantity)) {
                scales_[quantity] = learn(runs_, quantity);
            }
            kernels.emplace_back(domain_of(quantity), scales_.at(quantity),
                                 unit_of(known, static_cast<Eigen::Index>(kernels.size())));
        }
        process = std::make_unique<GaussianProcess>(std::move(kernels), known);
    }
    return *process;
}

Eigen::VectorXd Emulator::plain_mean(const std::vector<Query>& queries) const {
    Eigen::VectorXd result(static_cast<Eigen::Index>(queries.size()));
    for (const auto& [process, share] : shares_of(queries)) {
        result(share.queries) = share.map * process_of(process).mean(share.asked);
    }
    for (std::size_t k = 0; k < queries.size(); ++k) {
        if (!queries[k].by) {
            result(static_cast<Eigen::Index>(k)) +=
                unit_at(queries[k].which, queries[k].state).offset;
        }
    }
    return result;
}

Eigen::MatrixXd Emulator::plain_covariance(const std::vector<Query>& queries) const {
    const auto n = static_cast<Eigen::Index>(queries.size());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [process, share] : shares_of(queries)) {
        result(share.queries, share.queries) =
            share.map * process_of(process).covariance(share.asked) * share.map.transpose();
    }
    return result;
}

std::string Emulator::beyond(const FlowState& state) const {
    struct Known {
        const char* name;
        double value, least = INFINITY, greatest = -INFINITY;
        bool below_matters = true;
    };
    std::vector<Known> inputs = {
        {.name = "friction", .value = state.friction},
        {.name = "inertial number", .value = state.inertial_number, .below_matters = false}};
    if (!state.dry()) {
        inputs.push_back({.name = "reduced pressure", .value = 1 / state.inverse_pressure});
        inputs.push_back({.name = "bridge volume over a^3", .value = state.bridge_volume});
    }
    for (const auto& run : runs_) {
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
        if (above || (input.below_matters && input.value < input.least * (1 - rounding))) {
            text += fmt::format("{}{} {:.4g} is {} {:.4g}", text.empty() ? "" : ", ", input.name,
                                input.value, above ? "above" : "below",
                                above ? input.greatest : input.least);
        }
    }
    return text;
}

}  // namespace pendular
