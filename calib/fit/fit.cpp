#include "calib/fit/fit.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

namespace pendular {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Whitening of residuals and derivatives: multiplication by the inverse Cholesky factor of a
/// covariance.
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
    /// Sigma^-1 times a matrix.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& matrix) const { return llt_.solve(matrix); }

  private:
    Eigen::LLT<Eigen::MatrixXd> llt_;
};

/// Range of the parameters within both their bounds and the model's supported range.
ParameterBounds allowed(const Model& model) {
    ParameterBounds range = model.bounds();
    for (Eigen::Index k = 0; k < range.lower.size(); ++k) {
        const Parameter& p = model.parameters()[static_cast<std::size_t>(k)];
        range.lower(k) = std::max(range.lower(k), p.lower);
        range.upper(k) = std::min(range.upper(k), p.upper);
    }
    return range;
}

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

/// Ends a search of Ceres after more than 20 steps that led out of the range.
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

struct Minimum {
    Eigen::VectorXd parameters;
    double chi2 = 0;
    bool usable = false;
    bool converged = false;
    std::string message;
};

/// Settings of a search for a minimum.
struct Search {
    /// Initial trust-region radius of Ceres, in units of the columns' lengths of the derivatives.
    double radius = 1e4;
    bool bounded = false;  ///< whether Ceres receives the bounds from the start
};

/// Minimises chi2 with Ceres within the range, with the parameter `held` constant if given. With
/// bounds, Ceres searches along each step, however long, which leads far astray in curved valleys.
/// Therefore the first search has no bounds, and steps that leave the range are refused; a search
/// with bounds follows only if a step was refused.
Minimum minimise(const Model& model, const Measured& measured, const Whitening& whitening,
                 const ParameterBounds& range, const Eigen::VectorXd& start,
                 const FitEffort& effort, const Search& search = {},
                 std::optional<Eigen::Index> held = {}) {
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

/// Derivatives scaled to columns of length 1, so that they do not depend on the parameters' units.
struct Scaled {
    Eigen::MatrixXd jacobian;
    Eigen::VectorXd length;  ///< length of each column before scaling; 1 for a column of zeros

    explicit Scaled(Eigen::MatrixXd whitened) : jacobian(std::move(whitened)) {
        length = jacobian.colwise().norm();
        length = (length.array() > 0).select(length, 1.0);
        jacobian *= length.cwiseInverse().asDiagonal();
    }
};

/// Whether a step leaves the range of a parameter that is at an end of its range already.
bool leaves_at_bound(const ParameterBounds& range, Eigen::Index k, double at, double step) {
    const double close = 1e-6 * (range.upper(k) - range.lower(k));
    return (step < 0 && at - range.lower(k) < close) || (step > 0 && range.upper(k) - at < close);
}

/// Gauss-Newton step of the scaled parameters from `at` that leaves no range: parameters at an end
/// of their range from which the step would lead outside are held, and the others take the step
/// that is best without them.
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

/// Refines a minimum that Ceres found, near which chi2 is too flat to locate its minimum: takes
/// Gauss-Newton steps as long as they become shorter.
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

/// Covariance of the parameters, (J' J)^-1 of the whitened derivatives, by singular values of the
/// matrix with columns scaled to length 1, so that it does not depend on units. Combinations of
/// parameters that the residuals do not determine get errors larger than any range.
Eigen::MatrixXd parameter_covariance(const Eigen::MatrixXd& whitened_jacobian) {
    const Scaled scaled(whitened_jacobian);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled.jacobian, Eigen::ComputeThinV);
    const Eigen::VectorXd& s = svd.singularValues();
    const double least = s(0) > 0 ? 1e-10 * s(0) : 1e-10;
    const Eigen::VectorXd inverse = s.cwiseMax(least).cwiseInverse();
    const Eigen::MatrixXd root =
        scaled.length.cwiseInverse().asDiagonal() * svd.matrixV() * inverse.asDiagonal();
    return root * root.transpose();
}

/// Whether the standard error of each parameter, scaled by sqrt(chi2/dof), is smaller than its
/// range.
bool determined(const Fit& fit, const ParameterBounds& range) {
    const Eigen::ArrayXd variance = fit.covariance.diagonal();
    return (variance > 0).all() && (variance * fit.chi2 / std::max(fit.dof, 1) <
                                    (range.upper - range.lower).array().square())
                                       .all();
}

/// Part of the parameters' covariance C that comes from a part S of the covariance Sigma of the
/// readings: K S K' with the estimator K = C J' Sigma^-1.
Eigen::MatrixXd part_of(const Eigen::MatrixXd& covariance, const Whitening& whitening,
                        const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& part) {
    const Eigen::MatrixXd estimator = whitening.solve(jacobian) * covariance;  // K'
    return estimator.transpose() * part * estimator;
}

/// Adds the covariances between readings due to shared errors; the covariance of each reading
/// contains these errors already.
void add_shared_errors(const std::vector<Reading>& readings, Measured& measured) {
    struct Part {
        Eigen::Index entry;
        Eigen::Vector2d size;
    };
    std::map<std::size_t, std::vector<Part>> sources;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        for (const SharedError& error : readings[k].shared) {
            sources[error.source].push_back({2 * static_cast<Eigen::Index>(k), error.size});
        }
    }
    for (const auto& [source, parts] : sources) {
        for (const Part& a : parts) {
            for (const Part& b : parts) {
                if (a.entry == b.entry) continue;
                measured.covariance.block<2, 2>(a.entry, b.entry) += a.size * b.size.transpose();
            }
        }
    }
}

}  // namespace

Measured stack(const std::vector<Reading>& readings, const std::vector<DirectMeasurement>& direct) {
    const auto n = static_cast<Eigen::Index>(readings.size());
    const auto all = 2 * n + static_cast<Eigen::Index>(direct.size());
    Measured measured{Eigen::VectorXd(all), Eigen::MatrixXd::Zero(all, all),
                      Eigen::MatrixXd::Zero(all, all)};
    for (Eigen::Index k = 0; k < n; ++k) {
        const Reading& reading = readings[static_cast<std::size_t>(k)];
        measured.value.segment<2>(2 * k) = reading.value;
        measured.covariance.block<2, 2>(2 * k, 2 * k) = reading.estimated_covariance();
        measured.widening.block<2, 2>(2 * k, 2 * k) = reading.widened_by;
    }
    add_shared_errors(readings, measured);
    for (std::size_t k = 0; k < direct.size(); ++k) {
        const auto entry = 2 * n + static_cast<Eigen::Index>(k);
        measured.value(entry) = direct[k].value;
        measured.covariance(entry, entry) = std::pow(direct[k].standard_error, 2);
    }
    return measured;
}

double Fit::width(Eigen::Index k) const {
    return k < range.upper.size() ? range.upper(k) - range.lower(k)
                                  : std::numeric_limits<double>::infinity();
}

double Fit::standard_error(Eigen::Index k) const {
    return std::sqrt(covariance(k, k) + (widening.size() > 0 ? widening(k, k) : 0.0));
}
Eigen::VectorXd Fit::standard_errors() const {
    Eigen::VectorXd errors(parameters.size());
    for (Eigen::Index k = 0; k < errors.size(); ++k) {
        errors(k) = standard_error(k);
    }
    return errors;
}
double Fit::measurement_error(Eigen::Index k) const {
    return std::sqrt(measurement_part(k, k) + (widening.size() > 0 ? widening(k, k) : 0.0));
}
double Fit::simulation_error(Eigen::Index k) const {
    return std::sqrt(std::max(0.0, covariance(k, k) - measurement_part(k, k)));
}

namespace {

/// Largest number of searches, each with the weights of the result before it. Where the weights
/// change slowly with the parameters, two suffice; 12 are enough for a factor of 0.5 between the
/// steps of successive searches.
constexpr int most_reweightings = 12;
/// Length of a step [1], in standard errors of the parameters, below which new weights do not
/// matter: two orders below the digits that are printed, so that fits from different starts print
/// the same.
constexpr double same_optimum = 1e-3;
/// Length of the last step [1], in standard errors, from which a fit counts as not converged: a
/// tenth of a standard error is the last digit that is printed.
constexpr double unsettled = 0.1;

/// Least chi2 with constant weights.
Fit fit_with(const Whitening& whitening, const Model& model, const Measured& measured,
             const ParameterBounds& range, const Eigen::VectorXd& from, const FitEffort& effort) {
    Fit result;
    result.dof = static_cast<int>(measured.value.size() - from.size());
    result.chi2 = std::numeric_limits<double>::infinity();
    // A search may end on a plateau without reaching the minimum, so that others with different
    // settings follow from the same start.
    for (const Search& search : {Search{}, Search{.bounded = true}, Search{.radius = 1}}) {
        Minimum minimum = minimise(model, measured, whitening, range, from, effort, search);
        if (minimum.usable) {
            polish(model, measured, whitening, range, effort.settled, minimum);
        }
        if (minimum.chi2 < result.chi2) {
            result.parameters = minimum.parameters;
            result.chi2 = minimum.chi2;
            result.converged = minimum.converged;
            result.message = minimum.message;
            result.prediction = model.predict(minimum.parameters);
            result.covariance = parameter_covariance(whitening.apply(result.prediction.jacobian));
        }
        if (determined(result, range) || !effort.elsewhere) {
            break;
        }
    }
    return result;
}

/// Length of the step from fitted parameters to the optimum with other weights, in standard errors.
double distance_to_optimum(const Fit& fit, const Measured& measured, const Whitening& whitening,
                           const ParameterBounds& range) {
    const Scaled scaled(whitening.apply(fit.prediction.jacobian));
    const Eigen::VectorXd residuals = whitening.apply(measured.value - fit.prediction.value);
    return (scaled.jacobian * step_within(scaled, residuals, range, fit.parameters)).norm();
}

}  // namespace

Fit fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
        const FitEffort& effort) {
    const ParameterBounds range = allowed(model);
    const auto weights_of = [&](const Prediction& prediction) {
        return Whitening(measured.covariance + prediction.covariance);
    };
    const Eigen::VectorXd from = start.cwiseMax(range.lower).cwiseMin(range.upper);
    Fit result = fit_with(weights_of(model.predict(from)), model, measured, range, from, effort);
    Whitening whitening = weights_of(result.prediction);
    for (int turn = 1; turn < most_reweightings && effort.most_steps > 0 &&
                       distance_to_optimum(result, measured, whitening, range) > same_optimum;
         ++turn) {
        result = fit_with(whitening, model, measured, range, result.parameters, effort);
        whitening = weights_of(result.prediction);
    }
    // Not for quick refits: those of models that describe the readings badly may not settle, and
    // would drop out of the comparison of models.
    if (effort.elsewhere && effort.most_steps > 0 &&
        distance_to_optimum(result, measured, whitening, range) > unsettled) {
        result.converged = false;
        result.message =
            "the weights of the readings do not settle, since the error of the simulations depends "
            "strongly on the parameters";
    }
    result.chi2 = whitening.apply(measured.value - result.prediction.value).squaredNorm();
    result.covariance = parameter_covariance(whitening.apply(result.prediction.jacobian));
    const Eigen::VectorXd& parameters = result.parameters;
    const auto caused_by = [&](const Eigen::MatrixXd& part) {
        return part_of(result.covariance, whitening, result.prediction.jacobian, part);
    };
    result.measurement_part = caused_by(measured.covariance);
    if (measured.widening.size() > 0) result.widening = caused_by(measured.widening);
    result.run_part = caused_by(result.prediction.run_noise);
    for (Eigen::Index k = 0; k < parameters.size(); ++k) {
        if (!(result.prediction.jacobian.col(k).squaredNorm() > 0)) {
            result.converged = false;
            result.message = "the readings do not determine " +
                             model.parameters()[static_cast<std::size_t>(k)].name;
        }
    }
    for (Eigen::Index k = 0; k < parameters.size(); ++k) {
        const double close = 1e-6 * (range.upper(k) - range.lower(k));
        result.at_bound.push_back(parameters(k) - range.lower(k) < close ||
                                  range.upper(k) - parameters(k) < close);
    }
    result.range = range;
    return result;
}

Eigen::VectorXd best_parameters(const Model& model, const Measured& measured,
                                const Eigen::MatrixXd& covariance, const Eigen::VectorXd& start,
                                const FitEffort& effort) {
    const ParameterBounds range = allowed(model);
    const Whitening whitening(covariance);
    Minimum minimum = minimise(model, measured, whitening, range,
                               start.cwiseMax(range.lower).cwiseMin(range.upper), effort);
    if (minimum.usable) {
        polish(model, measured, whitening, range, effort.settled, minimum);
    }
    return minimum.parameters;
}

namespace {

/// Minimum of chi2 over all parameters but one, with the covariance of a fit.
class Profile {
  public:
    Profile(const Model& model, const Measured& measured, const Fit& best, Eigen::Index which)
        : model_(model),
          measured_(measured),
          best_(best),
          which_(which),
          whitening_(measured.covariance + best.prediction.covariance),
          range_(allowed(model)) {}

    const ParameterBounds& range() const { return range_; }
    /// chi2 where the parameter has this value; infinite where the readings are impossible.
    double chi2_at(double value, const FitEffort& effort) const {
        const Eigen::VectorXd start = start_at(value);
        if (start.size() > 1) {
            const Minimum minimum =
                minimise(model_, measured_, whitening_, range_, start, effort, {}, which_);
            return minimum.usable ? minimum.chi2 : INFINITY;
        }
        try {
            const Eigen::VectorXd predicted = model_.predict(start, PredictionPart::values).value;
            return whitening_.apply(measured_.value - predicted).squaredNorm();
        } catch (const std::domain_error&) {
            return INFINITY;
        }
    }

  private:
    /// Parameters that minimise chi2 where the model is linear.
    Eigen::VectorXd start_at(double value) const {
        Eigen::VectorXd start = best_.parameters;
        if (best_.covariance.rows() == start.size() && best_.covariance(which_, which_) > 0) {
            start += best_.covariance.col(which_) / best_.covariance(which_, which_) *
                     (value - best_.parameters(which_));
            start = start.cwiseMax(range_.lower).cwiseMin(range_.upper);
        }
        start(which_) = value;
        return start;
    }

    const Model& model_;
    const Measured& measured_;
    const Fit& best_;
    Eigen::Index which_;
    Whitening whitening_;
    ParameterBounds range_;
};

}  // namespace

std::pair<double, double> profile_interval(const Model& model, const Measured& measured,
                                           const Fit& best, Eigen::Index which, double rise) {
    const Profile profile(model, measured, best, which);
    const auto chi2_at = [&](double value) { return profile.chi2_at(value, {}); };
    const double limit = chi2_at(best.parameters(which)) + rise;
    const auto end = [&](double inside, double outside) {
        if (chi2_at(outside) < limit) {
            return outside;
        }
        // 2^-50 of the distance is its rounding error.
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (inside + outside);
            (chi2_at(middle) < limit ? inside : outside) = middle;
        }
        return 0.5 * (inside + outside);
    };
    return {end(best.parameters(which), profile.range().lower(which)),
            end(best.parameters(which), profile.range().upper(which))};
}

Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values) {
    const FitEffort effort{.most_steps = 50, .tolerance = 1e-6, .elsewhere = false};
    const Profile profile(model, measured, best, which);
    const double least = profile.chi2_at(best.parameters(which), effort);
    return values.unaryExpr([&](double value) { return profile.chi2_at(value, effort) - least; });
}

Eigen::VectorXd start_of(const Model& model) {
    const auto& parameters = model.parameters();
    Eigen::VectorXd start(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        start(static_cast<Eigen::Index>(k)) = parameters[k].start;
    }
    return start;
}

}  // namespace pendular
