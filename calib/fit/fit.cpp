#include "calib/fit/fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "calib/fit/least_squares.h"

namespace pendular {
namespace {

/// Covariance of the parameters, (J' J)^-1 of the whitened derivatives, by singular values of the
/// matrix with columns scaled to length 1, so that it does not depend on units. Combinations of
/// parameters that the residuals do not determine get errors larger than any range.
Eigen::MatrixXd parameter_covariance(const Eigen::MatrixXd& whitened_jacobian) {
    const Scaled scaled(whitened_jacobian);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled.jacobian, Eigen::ComputeThinV);
    const Eigen::VectorXd& s = svd.singularValues();
    const double least = s(0) > 0 ? 1e-10 * s(0) : 1e-10;  // above rounding, beyond any range
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

}  // namespace

double Fit::width(Eigen::Index k) const {
    return k < range.upper.size() ? range.upper(k) - range.lower(k)
                                  : std::numeric_limits<double>::infinity();
}

Eigen::MatrixXd Fit::total_covariance() const {
    Eigen::MatrixXd total = covariance;
    if (widening.size() > 0) total += widening;
    if (discrepancy_part.size() > 0) total += (inexactness * inexactness - 1) * discrepancy_part;
    return total;
}
double Fit::standard_error(Eigen::Index k) const {
    return std::sqrt(total_covariance()(k, k));
}
bool Fit::determines_all() const {
    for (Eigen::Index k = 0; k < parameters.size(); ++k)
        if (!determines(k)) return false;
    return true;
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
    const double discrepancy = discrepancy_part.size() > 0 ? discrepancy_part(k, k) : 0;
    return std::sqrt(std::max(0.0, covariance(k, k) - measurement_part(k, k) - discrepancy -
                                       std::pow(instrument_error(k), 2)));
}
double Fit::discrepancy_error(Eigen::Index k) const {
    return discrepancy_part.size() > 0 ? inexactness * std::sqrt(discrepancy_part(k, k)) : 0;
}
double Fit::instrument_error(Eigen::Index k, bool counts) const {
    double variance = 0;
    for (const InstrumentError& each : instrument) {
        if (each.counts == counts) variance += each.shift(k) * each.shift(k);
    }
    return std::sqrt(variance);
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
/// Ratio of successive steps [1] above which searches swing, between the 0.5 that 12 searches are
/// enough for and 1.
constexpr double still_nearing = 0.75;
/// Length of the last step [1], in standard errors, from which a fit counts as not converged: a
/// tenth of a standard error is the last digit that is printed.
constexpr double unsettled = 0.1;

/// Least chi2 with constant weights.
Fit fit_with(const Whitening& whitening, const Model& model, const Measured& measured,
             const ParameterBounds& range, const Eigen::VectorXd& from, const FitEffort& effort) {
    Fit result;
    result.dof = static_cast<int>(measured.informative() - from.size());
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
    Eigen::MatrixXd errors = result.prediction.covariance;  // of the weights of the next search
    // Without a step, parameters are only evaluated where they start.
    double distance =
        effort.most_steps > 0 ? distance_to_optimum(result, measured, whitening, range) : 0;
    for (int turn = 1; turn < most_reweightings && distance > same_optimum; ++turn) {
        const double before = distance;
        result = fit_with(Whitening(measured.covariance + errors), model, measured, range,
                          result.parameters, effort);
        whitening = weights_of(result.prediction);
        distance = distance_to_optimum(result, measured, whitening, range);
        // Searches that swing between two results find the one between them with mean weights.
        const double own = distance > still_nearing * before ? 0.5 : 1;
        errors = own * result.prediction.covariance + (1 - own) * errors;
    }
    // Not for quick refits: those of models that describe the readings badly may not settle, and
    // would drop out of the comparison of models.
    if (effort.elsewhere && distance > unsettled) {
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
    if (result.prediction.discrepancy.size() > 0)
        result.discrepancy_part = caused_by(result.prediction.discrepancy);
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

Eigen::VectorXd start_of(const Model& model) {
    const auto& parameters = model.parameters();
    Eigen::VectorXd start(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        start(static_cast<Eigen::Index>(k)) = parameters[k].start;
    }
    return start;
}

}  // namespace pendular
