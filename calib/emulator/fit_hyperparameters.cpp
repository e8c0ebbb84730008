#include "calib/emulator/fit_hyperparameters.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pendular {
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
