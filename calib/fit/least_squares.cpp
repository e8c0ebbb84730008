#include "calib/fit/least_squares.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace pendular {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

bool contains(const ParameterBounds& range, const Eigen::VectorXd& parameters) {
    return (parameters.array() >= range.lower.array()).all() &&
           (parameters.array() <= range.upper.array()).all();
}

/// Whitened residuals and their derivatives as a cost function of Ceres; it refuses parameters
/// outside the range.
class WhitenedResiduals : public ceres::CostFunction {
  public:
    WhitenedResiduals(const Model& model, const Measured& measured, const Whitening& whitening,
                      const ParameterBounds& range)
        : model_(model), measured_(measured), whitening_(whitening), range_(range) {
        set_num_residuals(static_cast<int>(measured.value.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(model.parameters().size()));
    }
    bool Evaluate(const double* const* parameters, double* residuals,
                  double** jacobians) const override {
        const auto n = static_cast<Eigen::Index>(model_.parameters().size());
        const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(parameters[0], n);
        if (!contains(range_, at)) {
            ++refused_;
            return false;
        }
        const bool derivatives = jacobians != nullptr && jacobians[0] != nullptr;
        Prediction prediction;
        try {
            prediction =
                model_.predict(at, derivatives ? PredictionPart::slopes : PredictionPart::values);
        } catch (const std::domain_error&) {
            return false;  // an effect so large that no true state can show the readings
        }
        if (!prediction.value.allFinite() || !prediction.jacobian.allFinite()) {
            return false;  // allFinite() is true for an empty matrix
        }
        Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) =
            whitening_.apply(measured_.value - prediction.value);
        if (derivatives) {
            Eigen::Map<RowMajor>(jacobians[0], num_residuals(), n) =
                -whitening_.apply(prediction.jacobian);
        }
        return true;
    }
    /// Number of evaluations refused because the parameters were outside the range.
    int refused() const { return refused_; }

  private:
    const Model& model_;
    const Measured& measured_;
    const Whitening& whitening_;
    const ParameterBounds& range_;
    mutable int refused_ = 0;
};

/// Ends a search of Ceres after more than 20 steps that led out of the range: the optimum then lies
/// outside, and the search with bounds that follows finds the end of the range. Chosen.
class StopAtTheEnd : public ceres::IterationCallback {
  public:
    explicit StopAtTheEnd(const WhitenedResiduals& residuals) : residuals_(residuals) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return residuals_.refused() > 20 ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                         : ceres::SOLVER_CONTINUE;
    }

  private:
    const WhitenedResiduals& residuals_;
};

/// Whether a step leaves the range of a parameter that is at an end of its range already, to a
/// millionth of the range, since searches end on a bound but for rounding.
bool leaves_at_bound(const ParameterBounds& range, Eigen::Index k, double at, double step) {
    const double close = 1e-6 * (range.upper(k) - range.lower(k));
    return (step < 0 && at - range.lower(k) < close) || (step > 0 && range.upper(k) - at < close);
}

}  // namespace

Whitening::Whitening(const Eigen::MatrixXd& covariance) : llt_(covariance) {
    if (llt_.info() != Eigen::Success) {
        throw std::logic_error("the covariance of the readings is not positive definite");
    }
}

Scaled::Scaled(Eigen::MatrixXd whitened) : jacobian(std::move(whitened)) {
    length = jacobian.colwise().norm();
    length = (length.array() > 0).select(length, 1.0);
    jacobian *= length.cwiseInverse().asDiagonal();
}

ParameterBounds allowed(const Model& model) {
    ParameterBounds range = model.bounds();
    for (Eigen::Index k = 0; k < range.lower.size(); ++k) {
        const Parameter& p = model.parameters()[static_cast<std::size_t>(k)];
        range.lower(k) = std::max(range.lower(k), p.lower);
        range.upper(k) = std::min(range.upper(k), p.upper);
    }
    return range;
}

// With bounds, Ceres searches along each step, however long, which leads far astray in curved
// valleys. Therefore the first search has no bounds, and steps that leave the range are refused; a
// search with bounds follows only if a step was refused.
Minimum minimise(const Model& model, const Measured& measured, const Whitening& whitening,
                 const ParameterBounds& range, const Eigen::VectorXd& start,
                 const FitEffort& effort, const Search& search, std::optional<Eigen::Index> held) {
    Minimum minimum{.parameters = start};
    double* block = minimum.parameters.data();
    const auto count = static_cast<int>(start.size());
    auto* residuals = new WhitenedResiduals(model, measured, whitening, range);
    ceres::Problem problem;
    problem.AddResidualBlock(residuals, nullptr, block);
    if (held) {
        problem.SetManifold(block, new ceres::SubsetManifold(count, {static_cast<int>(*held)}));
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.initial_trust_region_radius = search.radius;
    options.max_num_iterations = effort.most_steps;
    options.function_tolerance = effort.tolerance;
    options.gradient_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    if (!effort.elsewhere) {
        // Limits the evaluations along each step at bounds; the default of 20 suits cheap models.
        options.max_num_line_search_step_size_iterations = 3;
    }
    ceres::Solver::Summary summary;
    if (!search.bounded) {
        StopAtTheEnd stop(*residuals);
        options.callbacks = {&stop};
        ceres::Solve(options, &problem, &summary);
        options.callbacks.clear();
    }
    if (search.bounded || residuals->refused() > 0) {
        for (int k = 0; k < count; ++k) {
            problem.SetParameterLowerBound(block, k, range.lower(k));
            problem.SetParameterUpperBound(block, k, range.upper(k));
        }
        ceres::Solve(options, &problem, &summary);
    }
    minimum.chi2 = 2 * summary.final_cost;
    minimum.usable = summary.IsSolutionUsable();
    minimum.converged = minimum.usable && summary.termination_type == ceres::CONVERGENCE;
    minimum.message = summary.message;
    return minimum;
}

Eigen::VectorXd step_within(const Scaled& scaled, const Eigen::VectorXd& residuals,
                            const ParameterBounds& range, const Eigen::VectorXd& at) {
    Eigen::MatrixXd free = scaled.jacobian;
    for (Eigen::Index turn = 0; turn < at.size(); ++turn) {
        Eigen::VectorXd step = free.colPivHouseholderQr().solve(residuals);
        bool held = false;
        for (Eigen::Index k = 0; k < at.size(); ++k) {
            if (free.col(k).isZero(0)) {
                step(k) = 0;
            } else if (leaves_at_bound(range, k, at(k), step(k))) {
                free.col(k).setZero();
                held = true;
            }
        }
        if (!held) return step;
    }
    return Eigen::VectorXd::Zero(at.size());
}

void polish(const Model& model, const Measured& measured, const Whitening& whitening,
            const ParameterBounds& range, double settled, Minimum& minimum) {
    Eigen::VectorXd at = minimum.parameters;
    double shortest = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 100; ++turn) {
        const Prediction prediction = model.predict(at, PredictionPart::slopes);
        const Eigen::VectorXd residuals = whitening.apply(measured.value - prediction.value);
        const double chi2 = residuals.squaredNorm();
        const Scaled scaled(whitening.apply(prediction.jacobian));
        const Eigen::VectorXd step = step_within(scaled, residuals, range, at);
        const double length = (scaled.jacobian * step).norm();
        // Near the minimum, chi2 rises by no more than rounding errors.
        if (!(chi2 <= minimum.chi2 * (1 + 1e-9)) || !(length < shortest)) {
            return;
        }
        minimum.parameters = at;
        minimum.chi2 = chi2;
        shortest = length;
        at += step.cwiseQuotient(scaled.length);
        if (!contains(range, at)) {
            return;
        }
        if (length <= settled * std::sqrt(chi2)) {
            minimum.parameters = at;
            minimum.converged = true;
            return;
        }
    }
}

}  // namespace pendular
