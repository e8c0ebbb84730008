#include "calib/direct_simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

/// Sets of three runs that one round may order at each inertial number.
constexpr double most_sets = 8;

/// Short runs over the whole range, to find the neighbourhood of the answer.
constexpr double scout_frictions[] = {0.02, 0.07, 0.15, 0.3, 0.6};
constexpr double scout_share_of_strain = 0.4;

}  // namespace

std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest) {
    if (conditions.empty()) {
        return {};
    }
    const auto [slow, fast] = std::ranges::minmax(conditions, {}, &Condition::inertial_number);
    const double from = std::max(lowest, slow.inertial_number);
    double to = std::max(from, fast.inertial_number);
    if (slow.inertial_number < 0.95 * lowest) {
        to = std::max(to, lowest * 10 / 3);
    }
    if (to < 1.05 * from) {
        return {std::sqrt(from * to)};
    }
    const int gaps =
        std::max(1, static_cast<int>(std::ceil(std::log(to / from) / std::log(10.0 / 3) - 1e-6)));
    std::vector<double> levels;
    for (int k = 0; k <= gaps; ++k) {
        levels.push_back(from * std::pow(to / from, static_cast<double>(k) / gaps));
    }
    return levels;
}

DirectSimulation::DirectSimulation(const Study& study, const std::vector<Condition>& conditions,
                                   const Fidelity& fidelity, std::uint64_t seed, Workers workers)
    : grains_(study.grains),
      conditions_(conditions),
      fidelity_(fidelity),
      seed_(seed),
      workers_(std::move(workers)),
      parameters_{{.name = "friction", .lower = 0, .upper = 1, .start = 0.15}},
      inertial_numbers_(inertial_numbers_for(conditions, fidelity.lowest_inertial_number)) {
    if (!std::ranges::all_of(conditions, &Condition::dry)) {
        throw std::invalid_argument("direct simulation models dry conditions");
    }
}

void DirectSimulation::improve(const Eigen::VectorXd& parameters, double excess) {
    const double centre = parameters(0);
    if (runs_.empty()) {
        carry_out({std::begin(scout_frictions), std::end(scout_frictions)},
                  std::max(1.0, scout_share_of_strain * fidelity_.strain));
        renew_surfaces(centre, whole_range);
        return;
    }
    // The variance falls as one over the number of runs.
    const auto done = static_cast<double>(placed_);
    const int sets = static_cast<int>(std::clamp(std::ceil((excess - 1) * done), 1.0, most_sets));
    std::vector<double> frictions;
    for (int set = 0; set < sets; ++set) {
        for (const double offset : offsets[placed_++ % std::size(offsets)]) {
            frictions.push_back(std::clamp(ResponseSurface::friction_at(offset, centre),
                                           parameters_[0].lower, parameters_[0].upper));
        }
    }
    carry_out(frictions, fidelity_.strain);
    renew_surfaces(centre, window);
}

void DirectSimulation::restore(const std::vector<dem::RunResult>& runs, double centre) {
    for (const auto& run : runs) {
        add(run);
    }
    renew_surfaces(centre, window);
}

void DirectSimulation::renew_surfaces(double centre, double half_width) {
    if (points_.size() < 3) {
        throw dem::SimulationError("fewer than three runs succeeded; the last: " +
                                   (notes_.empty() ? std::string("none was made") : notes_.back()));
    }
    centre_ = centre;
    surfaces_.clear();
    for (const double exponent : {best_exponent, extreme_exponents[0], extreme_exponents[1]}) {
        surfaces_.emplace_back(points_, centre, exponent, half_width);
    }
}

void DirectSimulation::carry_out(const std::vector<double>& frictions, double strain) {
    std::vector<dem::RunParameters> wanted;
    for (const double inertial_number : inertial_numbers_) {
        for (const double friction : frictions) {
            wanted.push_back({.friction = friction,
                              .inertial_number = inertial_number,
                              .stiffness_number = fidelity_.stiffness_number,
                              .poisson_ratio = grains_.poisson_ratio,
                              .beads = fidelity_.beads,
                              .strain = strain,
                              .seed = seed_of_run(seed_, ordered_++)});
        }
    }
    for (const auto& run : run_all(wanted, workers_)) {
        add(run);
    }
}

void DirectSimulation::add(const dem::RunResult& run) {
    if (!run.failure.empty()) {
        notes_.push_back(fmt::format(
            "a run at friction {:.3g}, inertial number {:.3g} failed and is left out: {}",
            run.parameters.friction, run.parameters.inertial_number, run.failure));
        return;
    }
    runs_.push_back(run);
    const auto& p = run.parameters;
    if (run.crystallised) {
        notes_.push_back(fmt::format(
            "a run at friction {:.3g}, inertial number {:.3g} crystallised and is not used",
            p.friction, p.inertial_number));
        return;
    }
    if (!run.steady) {
        notes_.push_back(
            fmt::format("a run at friction {:.3g}, inertial number {:.3g} was not steady within a "
                        "strain of {:.3g}; its last part is used",
                        p.friction, p.inertial_number, run.strain_averaged + run.strain_transient));
    }
    const Mean& stress_ratio = run[dem::Observable::stress_ratio];
    const Mean& solid_fraction = run[dem::Observable::solid_fraction];
    SurfacePoint point{.friction = p.friction, .inertial_number = p.inertial_number};
    point.value << stress_ratio.value, solid_fraction.value;
    point.covariance << std::pow(stress_ratio.standard_error, 2), run.covariance, run.covariance,
        std::pow(solid_fraction.standard_error, 2);
    point.rigidity_shift =
        dem::rigidity_shift(solid_fraction.value, run[dem::Observable::mean_overlap].value);
    points_.push_back(point);
}

double DirectSimulation::stiffness_share(const Condition& condition) const {
    const auto studied = stiffness_number(condition.normal_stress, grains_);
    return studied ? 1 - fidelity_.stiffness_number / *studied : 0.0;
}

Prediction DirectSimulation::predict(const Eigen::VectorXd& parameters) const {
    return predict(parameters, conditions_);
}

Prediction DirectSimulation::predict(const Eigen::VectorXd& parameters,
                                     const std::vector<Condition>& conditions) const {
    if (surfaces_.empty()) {
        throw std::logic_error("predictions need runs: call improve first");
    }
    const double friction = parameters(0);
    const ResponseSurface& surface = surfaces_.front();
    const auto n = static_cast<Eigen::Index>(conditions.size());
    const Eigen::Index terms = surface.terms();
    const auto ratio = surface.coefficients().head(terms),
               fraction = surface.coefficients().tail(terms);
    Prediction prediction{
        .value = Eigen::VectorXd(2 * n), .jacobian = Eigen::MatrixXd(2 * n, 1), .covariance = {}};
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * n, 2 * terms);
    Eigen::VectorXd stiffness_error = Eigen::VectorXd::Zero(2 * n), form_error = stiffness_error;
    for (Eigen::Index k = 0; k < n; ++k) {
        const Condition& condition = conditions[static_cast<std::size_t>(k)];
        const double stress = condition.normal_stress, share = stiffness_share(condition);
        const Eigen::RowVectorXd basis = surface.basis(friction, condition.inertial_number);
        const Eigen::RowVectorXd slope = surface.basis_slope(friction, condition.inertial_number);
        rows.block(2 * k, 0, 1, terms) = stress * basis;
        rows.block(2 * k + 1, terms, 1, terms) = basis;
        const double shift = basis.dot(surface.shift());
        prediction.value(2 * k) = stress * basis.dot(ratio);
        prediction.value(2 * k + 1) = basis.dot(fraction) - share * shift;
        prediction.jacobian(2 * k, 0) = stress * slope.dot(ratio);
        prediction.jacobian(2 * k + 1, 0) =
            slope.dot(fraction) - share * slope.dot(surface.shift());
        stiffness_error(2 * k + 1) =
            share * shift * dem::rigidity_factor_error / dem::rigidity_factor;
        form_error.segment<2>(2 * k) =
            Eigen::Vector2d(stress, 1).cwiseProduct(
                surfaces_[1].value(friction, condition.inertial_number) -
                surfaces_[2].value(friction, condition.inertial_number)) /
            2;
    }
    prediction.run_noise = rows * surface.covariance() * rows.transpose();
    prediction.covariance = prediction.run_noise + stiffness_error * stiffness_error.transpose() +
                            form_error * form_error.transpose();
    return prediction;
}

DirectSimulation::Point DirectSimulation::predict_at(double friction,
                                                     const Condition& condition) const {
    const Prediction prediction = predict(Eigen::VectorXd::Constant(1, friction), {condition});
    const Eigen::Vector2d scale(1 / condition.normal_stress, 1);
    return {scale.cwiseProduct(Eigen::Vector2d(prediction.value)),
            scale.asDiagonal() * Eigen::Matrix2d(prediction.covariance) * scale.asDiagonal()};
}

Supported DirectSimulation::supported() const {
    return {Eigen::VectorXd::Constant(1, surfaces_.front().lowest_friction()),
            Eigen::VectorXd::Constant(1, surfaces_.front().highest_friction())};
}

}  // namespace pendular
