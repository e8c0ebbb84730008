#include "calib/direct_simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "data/input_error.h"
#include "sim/closures/terms.h"
#include "sim/seeds.h"

namespace pendular {
namespace {

/// How stress ratio and solid fraction approach their quasi-static limits: y(I) - y(0) ~
/// I^exponent. Published exponents lie between 0.4 (frictionless) and 1 (frictional); the
/// difference between the predictions of the two extremes gives the error of the form. Source:
/// Peyneau and Roux, Phys. Rev. E 78 (2008) 011307; Azema and Radjai, PRL 112 (2014) 078001.
constexpr double best_exponent = 0.75;
constexpr double extreme_exponents[] = {0.5, 1.0};

/// Half-width in ln(friction + 0.05) of what one surface covers, and where its runs are placed.
constexpr double window = 0.75;
constexpr double whole_range = 1e9;
constexpr double offsets[][3] = {
    {-0.4, 0, 0.4}, {-0.2, 0.1, 0.25}, {-0.3, -0.1, 0.3}, {-0.15, 0.05, 0.15}};

/// Half-widths around the centre, and around the bridge volume that is to give a liquid content,
/// in which wet runs are placed, in ln(friction + 0.05) and ln V0.
constexpr double wet_friction_width = 0.25, wet_volume_width = 0.2;

/// Sets of three runs that one round may order at each inertial number.
constexpr double most_sets = 8;

/// Times that one round may go through the wet settings.
constexpr double most_turns = 4;

/// Short runs over the whole range, to find the neighbourhood of the answer.
constexpr double scout_frictions[] = {0.02, 0.07, 0.15, 0.3, 0.6};
constexpr double scout_share_of_strain = 0.4;

std::string describe(const dem::RunParameters& p) {
    std::string text = fmt::format("a run at friction {:.3g}, inertial number {:.3g}", p.friction,
                                   p.inertial_number);
    if (p.wetting) {
        text += fmt::format(", reduced pressure {:.3g}, bridge volume {:.3g} a^3",
                            p.wetting->reduced_pressure, p.wetting->bridge_volume);
    }
    return text;
}

}  // namespace

DirectSimulation::DirectSimulation(const Study& study, const std::vector<Condition>& conditions,
                                   const Fidelity& fidelity, std::uint64_t seed, Workers workers)
    : study_(study),
      fidelity_(fidelity),
      seed_(seed),
      workers_(std::move(workers)),
      inertial_numbers_(inertial_numbers_for(conditions, fidelity.lowest_inertial_number)),
      wet_settings_(wet_settings_for(conditions, study, fidelity.lowest_inertial_number)),
      network_({}, 0) {
    predict_for(conditions);
}

void DirectSimulation::improve(const Eigen::VectorXd& parameters, double excess) {
    const double centre = parameters(0);
    const bool wet = !std::ranges::all_of(conditions(), &Condition::dry);
    if (runs_.empty()) {
        carry_out_dry({std::begin(scout_frictions), std::end(scout_frictions)},
                      std::max(1.0, scout_share_of_strain * fidelity_.strain));
        renew_surfaces(centre, whole_range);
    } else {
        // The variance falls as one over the number of runs.
        const auto done = static_cast<double>(placed_);
        const int sets =
            static_cast<int>(std::clamp(std::ceil((excess - 1) * done), 1.0, most_sets));
        std::vector<double> frictions;
        for (int set = 0; set < sets; ++set) {
            for (const double offset : offsets[placed_++ % std::size(offsets)]) {
                frictions.push_back(allowed(friction_at(offset, centre)));
            }
        }
        carry_out_dry(frictions, fidelity_.strain);
        renew_surfaces(centre, window);
    }
    if (wet) {
        learn_wet(parameters, static_cast<int>(std::clamp(std::ceil(excess - 1), 1.0, most_turns)));
    }
}

void DirectSimulation::learn_wet(const Eigen::VectorXd& parameters, int turns) {
    constexpr std::size_t fewest = 6;
    const std::size_t at_least = (fewest + wet_settings_.size() - 1) / wet_settings_.size();
    std::vector<WetSetting> settings;
    for (std::size_t turn = 0; turn < std::max(at_least, static_cast<std::size_t>(turns)); ++turn) {
        settings.insert(settings.end(), wet_settings_.begin(), wet_settings_.end());
    }
    const auto places =
        latin_places(settings, seed_of_run(seed_, wet_rounds_++, SeedDomain::run_places));
    std::vector<dem::RunParameters> wanted;
    for (std::size_t k = 0; k < settings.size(); ++k) {
        const WetSetting& setting = settings[k];
        const double friction = friction_at(wet_friction_width * places[k].first, parameters(0));
        FlowState state{.friction = allowed(friction),
                        .inertial_number = setting.inertial_number,
                        .inverse_pressure = setting.inverse_pressure};
        state.bridge_volume = network_.volume_of(setting.liquid_content, state) *
                              std::exp(wet_volume_width * places[k].second);
        wanted.push_back(run_at(state, study_, fidelity_));
    }
    carry_out(std::move(wanted));
    const auto usable =
        std::ranges::count_if(points_, [](const SurfacePoint& p) { return !p.state.dry(); });
    if (usable < 3) {
        throw dem::SimulationError("fewer than three wet runs succeeded; the last: " +
                                   (notes_.empty() ? std::string("none was made") : notes_.back()));
    }
    renew_surfaces(centre_, half_width_);
}

void DirectSimulation::restore(const std::vector<dem::RunResult>& runs, double centre) {
    for (const auto& run : runs) {
        add(run);
    }
    renew_surfaces(centre, window);
}

void DirectSimulation::renew_surfaces(double centre, double half_width) {
    const auto dry = dry_ones(points_);
    if (dry.size() < 3) {
        throw dem::SimulationError("fewer than three dry runs succeeded; the last: " +
                                   (notes_.empty() ? std::string("none was made") : notes_.back()));
    }
    centre_ = centre;
    half_width_ = half_width;
    surfaces_.clear();
    for (const double exponent : {best_exponent, extreme_exponents[0], extreme_exponents[1]}) {
        surfaces_.push_back({ResponseSurface(dry, centre, exponent, half_width),
                             ResponseSurface(points_, centre, exponent, half_width)});
    }
    network_ = BridgeNetwork(runs_, centre);
}

void DirectSimulation::carry_out_dry(const std::vector<double>& frictions, double strain) {
    std::vector<dem::RunParameters> wanted;
    for (const double inertial_number : inertial_numbers_) {
        for (const double friction : frictions) {
            wanted.push_back(run_at({friction, inertial_number}, study_, fidelity_));
            wanted.back().strain = strain;
        }
    }
    carry_out(std::move(wanted));
}

void DirectSimulation::carry_out(std::vector<dem::RunParameters> wanted) {
    for (auto& run : wanted) {
        run.seed = seed_of_run(seed_, ordered_++);
    }
    for (const auto& run : run_all(wanted, workers_)) {
        add(run);
    }
}

void DirectSimulation::add(const dem::RunResult& run) {
    const auto& p = run.parameters;
    if (!run.failure.empty()) {
        notes_.push_back(fmt::format("{} failed and is left out: {}", describe(p), run.failure));
        return;
    }
    runs_.push_back(run);
    if (run.crystallised) {
        notes_.push_back(fmt::format("{} crystallised and is not used", describe(p)));
        return;
    }
    if (!run.steady) {
        notes_.push_back(
            fmt::format("{} was not steady within a strain of {:.3g}; its last part is "
                        "used",
                        describe(p), run.strain_averaged + run.strain_transient));
    }
    const Mean& stress_ratio = run[dem::Observable::stress_ratio];
    const Mean& solid_fraction = run[dem::Observable::solid_fraction];
    SurfacePoint point{.state = {p.friction, p.inertial_number}};
    if (p.wetting) {
        point.state.inverse_pressure = 1 / p.wetting->reduced_pressure;
        point.state.bridge_volume = p.wetting->bridge_volume;
    }
    point.value << stress_ratio.value, solid_fraction.value;
    point.covariance << std::pow(stress_ratio.standard_error, 2), run.covariance, run.covariance,
        std::pow(solid_fraction.standard_error, 2);
    point.rigidity_shift =
        dem::rigidity_shift(solid_fraction.value, run[dem::Observable::mean_overlap].value);
    points_.push_back(point);
}

FlowState DirectSimulation::state_of(double friction, const Condition& condition) const {
    if (!condition.grain_effects.empty()) {
        throw InputError(
            fmt::format("direct simulation has no effects on grains, such as {}: leave out --cold",
                        condition.grain_effects.front().effect));
    }
    FlowState state{friction + condition.friction_difference, condition.inertial_number};
    if (!condition.dry()) {
        state.inverse_pressure = inverse_pressure_of(condition, study_);
        state.bridge_volume = network_.volume_of(condition.liquid_content, state);
    }
    return state;
}

/// What the prediction of one condition is made of: rows over the terms of its surface.
struct DirectSimulation::Terms {
    FlowState state;
    Eigen::RowVectorXd basis, slope;  ///< slope: by friction, at constant liquid content
};

DirectSimulation::Terms DirectSimulation::terms_of(double friction,
                                                   const Condition& condition) const {
    Terms terms{.state = state_of(friction, condition), .basis = {}, .slope = {}};
    const ResponseSurface& surface = surfaces_.front().of(terms.state);
    terms.basis = surface.basis(terms.state);
    terms.slope = surface.basis_slope(terms.state);
    if (!terms.state.dry()) {
        terms.slope +=
            surface.basis_volume_slope(terms.state) * network_.log_volume_slope(terms.state);
    }
    return terms;
}

Prediction DirectSimulation::predict_conditions(const Eigen::VectorXd& parameters,
                                                const std::vector<Condition>& conditions) const {
    if (surfaces_.empty()) {
        throw std::logic_error("predictions need runs: call improve first");
    }
    const double friction = parameters(0);
    const Surfaces& best = surfaces_.front();
    const Eigen::Index dry_terms = 2 * best.dry.terms(), all_terms = 2 * best.all.terms();
    const auto n = static_cast<Eigen::Index>(conditions.size());
    Prediction prediction{
        .value = Eigen::VectorXd(2 * n), .jacobian = Eigen::MatrixXd(2 * n, 1), .covariance = {}};
    Eigen::MatrixXd dry_rows = Eigen::MatrixXd::Zero(2 * n, dry_terms);
    Eigen::MatrixXd all_rows = Eigen::MatrixXd::Zero(2 * n, all_terms);
    Eigen::VectorXd stiffness_error = Eigen::VectorXd::Zero(2 * n), form_error = stiffness_error;
    for (Eigen::Index k = 0; k < n; ++k) {
        const Condition& condition = conditions[static_cast<std::size_t>(k)];
        const double stress = condition.normal_stress,
                     share = stiffness_share(fidelity_.stiffness_number, condition, study_.grains,
                                             fidelity_);
        const Terms terms = terms_of(friction, condition);
        const ResponseSurface& surface = best.of(terms.state);
        const Eigen::Index size = surface.terms();
        const auto ratio = surface.coefficients().head(size),
                   fraction = surface.coefficients().tail(size);
        Eigen::MatrixXd& rows = terms.state.dry() ? dry_rows : all_rows;
        rows.block(2 * k, 0, 1, size) = stress * terms.basis;
        rows.block(2 * k + 1, size, 1, size) = terms.basis;
        const double shift = terms.basis.dot(surface.shift());
        prediction.value(2 * k) = stress * terms.basis.dot(ratio);
        prediction.value(2 * k + 1) = terms.basis.dot(fraction) - share * shift;
        prediction.jacobian(2 * k, 0) = stress * terms.slope.dot(ratio);
        prediction.jacobian(2 * k + 1, 0) =
            terms.slope.dot(fraction) - share * terms.slope.dot(surface.shift());
        stiffness_error(2 * k + 1) =
            share * shift * dem::rigidity_factor_error / dem::rigidity_factor;
        form_error.segment<2>(2 * k) = Eigen::Vector2d(stress, 1).cwiseProduct(
                                           surfaces_[1].of(terms.state).value(terms.state) -
                                           surfaces_[2].of(terms.state).value(terms.state)) /
                                       2;
    }
    const Eigen::MatrixXd shared =
        dry_rows * best.all.covariance_with(best.dry) * all_rows.transpose();
    prediction.run_noise = dry_rows * best.dry.covariance() * dry_rows.transpose() +
                           all_rows * best.all.covariance() * all_rows.transpose() + shared +
                           shared.transpose();
    prediction.covariance = prediction.run_noise + stiffness_error * stiffness_error.transpose() +
                            form_error * form_error.transpose();
    return prediction;
}

StructureResponse DirectSimulation::effective_coordination(double friction,
                                                           const Condition& condition) const {
    const FlowState state = state_of(friction, condition);
    return network_.at_constant_content(network_.effective_coordination(state), state);
}

StructureResponse DirectSimulation::capillary_shear_stress(double friction,
                                                           const Condition& condition) const {
    const FlowState state = state_of(friction, condition);
    return network_.at_constant_content(network_.capillary_shear_stress(state), state);
}

Supported DirectSimulation::supported() const {
    return {Eigen::VectorXd::Constant(1, surfaces_.front().dry.lowest_friction()),
            Eigen::VectorXd::Constant(1, surfaces_.front().dry.highest_friction())};
}

}  // namespace pendular
