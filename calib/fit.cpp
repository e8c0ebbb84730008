#include "calib/fit.h"

#include <ceres/ceres.h>
#include <ceres/covariance.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pendular {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Inverse Cholesky factor of a covariance, applied to residuals and derivatives.
class Whitening {
  public:
    explicit Whitening(const Eigen::MatrixXd& covariance) : llt_(covariance) {
        if (llt_.info() != Eigen::Success) {
            throw std::logic_error("the covariance of the readings is not positive definite");
        }
    }
    template <typename Matrix>
    Eigen::MatrixXd apply(const Matrix& matrix) const {
        return llt_.matrixL().solve(Eigen::MatrixXd(matrix));
    }

  private:
    Eigen::LLT<Eigen::MatrixXd> llt_;
};

/// Whitened residuals and their derivatives as Ceres wants them.
class WhitenedResiduals : public ceres::CostFunction {
  public:
    WhitenedResiduals(const Model& model, const Measured& measured, const Whitening& whitening)
        : model_(model), measured_(measured), whitening_(whitening) {
        set_num_residuals(static_cast<int>(measured.value.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(model.parameters().size()));
    }
    bool Evaluate(const double* const* parameters, double* residuals,
                  double** jacobians) const override {
        const auto n = static_cast<Eigen::Index>(model_.parameters().size());
        const Prediction prediction =
            model_.predict_mean(Eigen::Map<const Eigen::VectorXd>(parameters[0], n));
        Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) =
            whitening_.apply(measured_.value - prediction.value);
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<RowMajor>(jacobians[0], num_residuals(), n) =
                -whitening_.apply(prediction.jacobian);
        }
        return true;
    }

  private:
    const Model& model_;
    const Measured& measured_;
    const Whitening& whitening_;
};

/// Where both the parameter's own range and the model's support allow it.
Supported allowed(const Model& model) {
    Supported range = model.supported();
    for (Eigen::Index k = 0; k < range.lower.size(); ++k) {
        const Parameter& p = model.parameters()[static_cast<std::size_t>(k)];
        range.lower(k) = std::max(range.lower(k), p.lower);
        range.upper(k) = std::min(range.upper(k), p.upper);
    }
    return range;
}

struct Minimum {
    Eigen::VectorXd parameters;
    double chi2 = 0;
    bool usable = false;
    bool converged = false;
    std::string message;
};

/// Minimises with Ceres within the range.
Minimum minimise(ceres::Problem& problem, Eigen::VectorXd& parameters, const Supported& range) {
    for (Eigen::Index k = 0; k < parameters.size(); ++k) {
        problem.SetParameterLowerBound(parameters.data(), static_cast<int>(k), range.lower(k));
        problem.SetParameterUpperBound(parameters.data(), static_cast<int>(k), range.upper(k));
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 200;
    options.function_tolerance = 1e-14;
    options.gradient_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return {parameters, 2 * summary.final_cost, summary.IsSolutionUsable(),
            summary.termination_type == ceres::CONVERGENCE, summary.message};
}

/// Adds the model's residuals on the block `parameters`, which must outlive the problem.
void add_residuals(ceres::Problem& problem, const Model& model, const Measured& measured,
                   const Whitening& whitening, Eigen::VectorXd& parameters) {
    problem.AddResidualBlock(new WhitenedResiduals(model, measured, whitening), nullptr,
                             parameters.data());
}

/// Covariance of the parameters by Ceres; a variance of zero stands for one that the residuals do
/// not determine.
Eigen::MatrixXd parameter_covariance(ceres::Problem& problem, const Eigen::VectorXd& parameters) {
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::DENSE_SVD;
    options.null_space_rank = -1;
    ceres::Covariance covariance(options);
    const auto n = parameters.size();
    RowMajor result = RowMajor::Zero(n, n);
    const std::vector<const double*> blocks = {parameters.data()};
    if (covariance.Compute(blocks, &problem)) {
        covariance.GetCovarianceBlock(parameters.data(), parameters.data(), result.data());
    }
    return result;
}

/// Share of the parameters' covariance that comes from a part S of the readings' covariance: K S K'
/// with the estimator K = C J' Sigma^-1.
Eigen::MatrixXd part_of(const Eigen::MatrixXd& covariance, const Whitening& whitening,
                        const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& part) {
    const Eigen::MatrixXd whitened_jacobian = whitening.apply(jacobian);
    const Eigen::MatrixXd half = whitening.apply(part);                  // L^-1 S
    const Eigen::MatrixXd whitened = whitening.apply(half.transpose());  // L^-1 S L^-T
    return covariance * whitened_jacobian.transpose() * whitened * whitened_jacobian * covariance;
}

}  // namespace

Measured stack(const std::vector<Reading>& readings) {
    const auto n = static_cast<Eigen::Index>(readings.size());
    Measured measured{Eigen::VectorXd(2 * n), Eigen::MatrixXd::Zero(2 * n, 2 * n)};
    for (Eigen::Index k = 0; k < n; ++k) {
        measured.value.segment<2>(2 * k) = readings[static_cast<std::size_t>(k)].value;
        measured.covariance.block<2, 2>(2 * k, 2 * k) =
            readings[static_cast<std::size_t>(k)].covariance;
    }
    return measured;
}

double Fit::standard_error(Eigen::Index k) const {
    return std::sqrt(covariance(k, k));
}
double Fit::measurement_error(Eigen::Index k) const {
    return std::sqrt(measurement_part(k, k));
}
double Fit::simulation_error(Eigen::Index k) const {
    return std::sqrt(std::max(0.0, covariance(k, k) - measurement_part(k, k)));
}

Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start) {
    const Supported range = allowed(model);
    Eigen::VectorXd parameters = start.cwiseMax(range.lower).cwiseMin(range.upper);
    const Whitening whitening(measured.covariance + model.predict(parameters).covariance);
    ceres::Problem problem;
    add_residuals(problem, model, measured, whitening, parameters);
    const Minimum minimum = minimise(problem, parameters, range);

    Fit result;
    result.parameters = parameters;
    result.covariance = parameter_covariance(problem, parameters);
    result.prediction = model.predict(parameters);
    const auto caused_by = [&](const Eigen::MatrixXd& part) {
        return part_of(result.covariance, whitening, result.prediction.jacobian, part);
    };
    result.measurement_part = caused_by(measured.covariance);
    result.run_part = caused_by(result.prediction.run_noise);
    result.chi2 = minimum.chi2;
    result.dof = static_cast<int>(measured.value.size() - parameters.size());
    result.converged = minimum.usable && minimum.converged;
    result.message = minimum.message;
    for (Eigen::Index k = 0; k < parameters.size(); ++k) {
        if (!(result.covariance(k, k) > 0)) {
            result.converged = false;
            result.message = "the readings do not determine " +
                             model.parameters()[static_cast<std::size_t>(k)].name;
        }
    }
    for (Eigen::Index k = 0; k < parameters.size(); ++k) {
        const Parameter& p = model.parameters()[static_cast<std::size_t>(k)];
        const double close = 1e-6 * (p.upper - p.lower);
        result.at_bound.push_back(parameters(k) - p.lower < close ||
                                  p.upper - parameters(k) < close);
    }
    return result;
}

std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise) {
    const Whitening whitening(measured.covariance + best.prediction.covariance);
    const Supported range = allowed(model);
    const auto chi2_at = [&](double value) {
        Eigen::VectorXd parameters = best.parameters;
        parameters(which) = value;
        if (parameters.size() == 1) {
            return whitening.apply(measured.value - model.predict(parameters).value).squaredNorm();
        }
        ceres::Problem problem;
        add_residuals(problem, model, measured, whitening, parameters);
        problem.SetManifold(parameters.data(),
                            new ceres::SubsetManifold(static_cast<int>(parameters.size()),
                                                      {static_cast<int>(which)}));
        return minimise(problem, parameters, range).chi2;
    };
    const double limit = chi2_at(best.parameters(which)) + rise;
    const auto end = [&](double inside, double outside) {
        if (chi2_at(outside) < limit) {
            return outside;
        }
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (inside + outside);
            (chi2_at(middle) < limit ? inside : outside) = middle;
        }
        return 0.5 * (inside + outside);
    };
    return {end(best.parameters(which), range.lower(which)),
            end(best.parameters(which), range.upper(which))};
}

Eigen::VectorXd start_of(const Model& model) {
    const auto& parameters = model.parameters();
    Eigen::VectorXd start(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        start(static_cast<Eigen::Index>(k)) = parameters[k].start;
    }
    return start;
}

Fit calibrate(Model& model, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report) {
    Eigen::VectorXd at = options.start.value_or(start_of(model));
    // Largest ratio of the variance that the runs' noise causes in a parameter to what is allowed.
    const auto excess_of = [&](const Fit& fit) {
        const double allowed = options.simulation_share / (1 - options.simulation_share);
        double excess = 0;
        for (Eigen::Index k = 0; k < at.size(); ++k) {
            const double noise = fit.run_part(k, k), rest = fit.covariance(k, k) - noise;
            excess = std::max(excess, rest > 0 ? noise / rest / allowed : 1e3);
        }
        return excess;
    };
    const auto settled = [&](const Fit& fit) {
        return ((fit.parameters - at).cwiseAbs().array() <=
                options.settled * fit.covariance.diagonal().cwiseSqrt().array())
            .all();
    };
    Fit best;
    double excess = 1;
    for (int round = 1; round <= options.most_rounds; ++round) {
        model.improve(at, excess);
        best = fit(model, measured, at);
        // Once more with the weights of the answer itself.
        best = fit(model, measured, best.parameters);
        if (report) {
            report(round, best);
        }
        excess = excess_of(best);
        const bool done =
            round >= options.fewest_rounds && settled(best) && excess <= 1 && model.confirmed();
        at = best.parameters;
        // What the readings do not determine, more simulation cannot.
        if (done || (round >= options.fewest_rounds && !best.converged)) {
            return best;
        }
    }
    if (options.most_rounds == 1) {
        return best;
    }
    best.converged = false;
    best.message = "the parameters had not settled after the last round of simulations";
    return best;
}

}  // namespace pendular
