#include "calib/emulator/gaussian_process.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "calib/emulator/wide_products.h"

namespace pendular {

Observations Observations::only(Eigen::Index quantity) const {
    Observations one{.at = at, .values = values.col(quantity), .noise = {}};
    for (const auto& each : noise) {
        one.noise.push_back(each.block(quantity, quantity, 1, 1));
    }
    return one;
}

GaussianProcess::GaussianProcess(std::vector<Kernel> kernels, const Observations& known)
    : kernels_(std::move(kernels)) {
    const auto n = static_cast<Eigen::Index>(known.at.size()),
               m = static_cast<Eigen::Index>(kernels_.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n * m, n * m);
    Eigen::VectorXd growth(m), between_run_scatter(m);
    for (Eigen::Index k = 0; k < m; ++k) {
        const Kernel& kernel = kernels_[static_cast<std::size_t>(k)];
        known_.push_back(kernel.prepare(known.at));
        matrix.block(k * n, k * n, n, n) = kernel.matrix(known_.back());
        growth(k) = std::sqrt(kernel.hyperparameters().noise);
        between_run_scatter(k) = kernel.hyperparameters().between_run_scatter;
    }
    for (Eigen::Index i = 0; i < n; ++i) {
        Eigen::MatrixXd noise =
            growth.asDiagonal() * known.noise[static_cast<std::size_t>(i)] * growth.asDiagonal();
        noise.diagonal() += between_run_scatter.cwiseAbs2();
        for (Eigen::Index k = 0; k < m; ++k) {
            for (Eigen::Index l = 0; l < m; ++l) {
                matrix(k * n + i, l * n + i) += noise(k, l);
            }
        }
    }
    factor_.compute(matrix);
    if (factor_.info() != Eigen::Success) {
        throw std::logic_error("the covariance of the runs is not positive definite");
    }
    const Eigen::MatrixXd weights = factor_.solve(known.values.reshaped()).reshaped(n, m);
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
        sums_over_.push_back(
            kernels_[k].known(known_[k], weights.col(static_cast<Eigen::Index>(k))));
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(known_[k].front().polynomial.size());
        for (Eigen::Index i = 0; i < n; ++i) {
            sum += weights(i, static_cast<Eigen::Index>(k)) *
                   known_[k][static_cast<std::size_t>(i)].polynomial.transpose();
        }
        coefficients_.push_back(kernels_[k].coefficient_variance() * sum);
    }
}

Eigen::MatrixXd GaussianProcess::with_known(const std::vector<Requested>& requested) const {
    const auto n = static_cast<Eigen::Index>(known_.front().size());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n * static_cast<Eigen::Index>(kernels_.size()),
                                                   static_cast<Eigen::Index>(requested.size()));
    for (Eigen::Index c = 0; c < result.cols(); ++c) {
        const Requested& one = requested[static_cast<std::size_t>(c)];
        const auto quantity = static_cast<std::size_t>(one.quantity);
        const Kernel::Prepared at = prepared(one);
        for (Eigen::Index i = 0; i < n; ++i) {
            result(one.quantity * n + i, c) =
                kernels_[quantity](known_[quantity][static_cast<std::size_t>(i)], at);
        }
    }
    return result;
}

Eigen::VectorXd GaussianProcess::mean(const std::vector<Requested>& requested) const {
    // The value and the derivatives at one place follow from the same sums.
    struct Place {
        Eigen::Index quantity;
        Coordinates at;
        std::array<double, 1 + coordinate_count> sums;
    };
    std::vector<Place> places;
    const bool by_pressure = std::ranges::any_of(requested, [](const Requested& one) {
        return one.functional.derivative == pressure_coordinate;
    });
    Eigen::VectorXd result(static_cast<Eigen::Index>(requested.size()));
    for (std::size_t c = 0; c < requested.size(); ++c) {
        const auto quantity = static_cast<std::size_t>(requested[c].quantity);
        const Kernel::Prepared at = prepared(requested[c]);
        auto place = std::find_if(places.begin(), places.end(), [&](const Place& known) {
            return known.quantity == requested[c].quantity &&
                   known.at == requested[c].functional.at;
        });
        if (place == places.end()) {
            place = places.insert(place,
                                  {requested[c].quantity, requested[c].functional.at,
                                   kernels_[quantity].sums(sums_over_[quantity], at, by_pressure)});
        }
        // The polynomial is evaluated by its coefficients: a sum over the runs would lose digits.
        result(static_cast<Eigen::Index>(c)) =
            at.polynomial.dot(coefficients_[quantity]) +
            place->sums[static_cast<std::size_t>(1 + requested[c].functional.derivative)];
    }
    return result;
}

GaussianProcess::Solved GaussianProcess::solve(std::vector<Requested> requested) const {
    std::vector<Kernel::Prepared> places;
    for (const Requested& one : requested) {
        places.push_back(prepared(one));
    }
    Eigen::MatrixXd half = solve_lower(factor_.matrixLLT(), with_known(requested));
    return {std::move(requested), std::move(places), std::move(half)};
}

double GaussianProcess::prior_covariance(const Solved& a, std::size_t i, const Solved& b,
                                         std::size_t j) const {
    const Eigen::Index quantity = a.requested[i].quantity;
    return quantity == b.requested[j].quantity
               ? kernels_[static_cast<std::size_t>(quantity)](a.places[i], b.places[j])
               : 0.0;
}

Eigen::MatrixXd GaussianProcess::covariance_of(const Solved& requested) const {
    const Eigen::MatrixXd& half = requested.half;
    Eigen::MatrixXd result = -transposed_product(half, half);
    for (std::size_t i = 0; i < requested.places.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
                prior_covariance(requested, i, requested, j);
        }
    }
    return result.selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd GaussianProcess::covariance_between(const Solved& a, const Solved& b) const {
    Eigen::MatrixXd result = -transposed_product(a.half, b.half);
    for (std::size_t i = 0; i < a.places.size(); ++i) {
        for (std::size_t j = 0; j < b.places.size(); ++j) {
            result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
                prior_covariance(a, i, b, j);
        }
    }
    return result;
}

namespace {

/// Log-normal prior of each hyperparameter: its median and the standard deviation of its logarithm.
/// Median lengths are of the order of the range of the coordinates, median amplitudes a tenth of
/// the quantity. Deviations of 0.7 and 2 are factors of 2 and 7 either way, so that a few runs
/// decide. The prior of the noise factor allows for standard errors that block averages estimate to
/// some 20 %.
struct Broad {
    Hyperparameters median;
    std::array<double, Hyperparameters::count> deviation;
};

Broad prior(double unit) {
    return {.median = {.dry_amplitude = 0.1 * unit,
                       .dry_x = 1,
                       .dry_q = 0.2,
                       .wet_amplitude = 0.1 * unit,
                       .wet_x = 1,
                       .wet_q = 0.2,
                       .wet_u = 1,
                       .wet_v = 2,
                       .noise = 1,
                       .between_run_scatter = 1e-3 * unit},
            .deviation = {2, 0.7, 0.7, 2, 0.7, 0.7, 0.7, 0.7, 0.3, 2}};
}

/// `hyperparameter_cost` as the cost function of a Ceres problem, in the logarithms of the
/// hyperparameters.
class Cost : public ceres::FirstOrderFunction {
  public:
    Cost(Domain domain, const Observations& known, double unit)
        : domain_(domain), known_(known), unit_(unit) {}
    bool Evaluate(const double* logarithms, double* cost, double* gradient) const override {
        std::array<double, Hyperparameters::count> hyperparameters;
        std::transform(logarithms, logarithms + Hyperparameters::count, hyperparameters.begin(),
                       [](double log) { return std::exp(log); });
        *cost = hyperparameter_cost(domain_, known_, unit_,
                                    Hyperparameters::from_array(hyperparameters), gradient);
        return std::isfinite(*cost);
    }
    int NumParameters() const override { return Hyperparameters::count; }

  private:
    Domain domain_;
    const Observations& known_;
    double unit_;
};

}  // namespace

double hyperparameter_cost(Domain domain, const Observations& known, double unit,
                           const Hyperparameters& hyperparameters, double* gradient) {
    const Kernel kernel(domain, hyperparameters, unit);
    const auto n = static_cast<Eigen::Index>(known.at.size());
    Eigen::VectorXd noise(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        noise(i) = hyperparameters.noise * known.noise[static_cast<std::size_t>(i)](0, 0);
    }
    const auto places = kernel.prepare(known.at);
    Eigen::MatrixXd matrix = kernel.matrix(places);
    matrix.diagonal().array() +=
        noise.array() + hyperparameters.between_run_scatter * hyperparameters.between_run_scatter;
    const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
    if (factor.info() != Eigen::Success) {
        return INFINITY;
    }
    const Eigen::VectorXd weights = factor.solve(known.values.col(0));
    double cost = 0.5 * known.values.col(0).dot(weights) +
                  Eigen::MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    const Broad broad = prior(unit);
    const auto at = hyperparameters.as_array(), median = broad.median.as_array();
    std::array<double, Hyperparameters::count> slopes{};
    for (std::size_t k = 0; k < Hyperparameters::count; ++k) {
        const double off = std::log(at[k] / median[k]) / broad.deviation[k];
        cost += 0.5 * off * off;
        slopes[k] = off / broad.deviation[k];
    }
    if (gradient != nullptr) {
        // d(cost)/d(theta) = 1/2 tr[(K^-1 - w w') dK/d(theta)].
        const Eigen::MatrixXd spread =
            factor.solve(Eigen::MatrixXd::Identity(n, n)) - weights * weights.transpose();
        const auto traces = kernel.half_traces(places, spread);
        for (std::size_t k = 0; k < traces.size(); ++k) {
            gradient[k] = slopes[k] + traces[k];
        }
        gradient[Hyperparameters::of_processes] =
            slopes[Hyperparameters::of_processes] + 0.5 * spread.diagonal().dot(noise);
        gradient[Hyperparameters::count - 1] =
            slopes.back() + spread.trace() * hyperparameters.between_run_scatter *
                                hyperparameters.between_run_scatter;
    }
    return cost;
}

Hyperparameters fit_hyperparameters(Domain domain, const Observations& known, double unit) {
    if (known.at.empty()) {
        throw std::invalid_argument("the fit of hyperparameters needs training runs");
    }
    auto hyperparameters = prior(unit).median.as_array();
    std::ranges::transform(hyperparameters, hyperparameters.begin(),
                           [](double value) { return std::log(value); });
    const ceres::GradientProblem problem(new Cost(domain, known, unit));
    ceres::GradientProblemSolver::Options options;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-7;
    ceres::GradientProblemSolver::Summary summary;
    ceres::Solve(options, problem, hyperparameters.data(), &summary);
    std::ranges::transform(hyperparameters, hyperparameters.begin(),
                           [](double log) { return std::exp(log); });
    return Hyperparameters::from_array(hyperparameters);
}

}  // namespace pendular
