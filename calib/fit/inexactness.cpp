#include "calib/fit/inexactness.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "calib/model/discrepancy.h"

namespace pendular {
namespace {

/// Number of steps from the expected discrepancy to `largest_inexactness` times as much, each 1.26
/// times the one before: chosen, since no reading tells smaller steps apart.
constexpr int steps = 4;

/// Smallest gain of the log likelihood, with the prior where there is one, at which more
/// discrepancy than expected is seen: p = 0.05 with the size at the bound of its range (half of
/// chi2 with one degree of freedom beyond 2.71).
constexpr double significant = 2.71 / 2;

/// Residuals and derivatives, divided by the Cholesky factor of a covariance.
struct Whitened {
    Eigen::VectorXd residuals;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> slopes;
    double log_determinant = 0;  ///< of the covariance

    Whitened(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& residuals_,
             const Eigen::MatrixXd& derivatives) {
        const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
        const Eigen::MatrixXd lower = factor.matrixL();
        residuals = lower.triangularView<Eigen::Lower>().solve(residuals_);
        slopes.compute(lower.triangularView<Eigen::Lower>().solve(derivatives));
        log_determinant = 2 * lower.diagonal().array().log().sum();
    }
    /// chi2 without the part that the derivatives can imitate.
    double chi2() const {
        const Eigen::VectorXd turned = slopes.householderQ().transpose() * residuals;
        return turned.tail(turned.size() - slopes.rank()).squaredNorm();
    }
    double restricted() const {
        return -log_determinant / 2 - chi2() / 2 -
               slopes.matrixQR().diagonal().head(slopes.rank()).array().abs().log().sum();
    }
};

}  // namespace

double restricted_log_likelihood(const Eigen::MatrixXd& covariance,
                                 const Eigen::VectorXd& residuals,
                                 const Eigen::MatrixXd& derivatives) {
    return Whitened(covariance, residuals, derivatives).restricted();
}

Inexactness likely_inexactness(const Measured& measured, const Prediction& prediction,
                               const std::vector<bool>& at_bound, double largest) {
    const Eigen::MatrixXd exact = measured.covariance + prediction.covariance;
    const Eigen::VectorXd residuals = measured.value - prediction.value;
    const bool inexact = prediction.discrepancy.size() > 0 && largest > 1;
    Eigen::MatrixXd slopes = prediction.jacobian;
    for (std::size_t k = 0; k < at_bound.size(); ++k)
        if (at_bound[k]) slopes.col(static_cast<Eigen::Index>(k)).setZero();
    Inexactness best;
    double to_beat = -INFINITY;
    for (int step = 0; step <= (inexact ? steps : 0); ++step) {
        const double factor = std::pow(largest, static_cast<double>(step) / steps);
        const double more = factor * factor - 1;
        const Whitened whitened(
            more > 0 ? Eigen::MatrixXd(exact + more * prediction.discrepancy) : exact, residuals,
            slopes);
        const double prior = std::pow(std::log(factor) / std::numbers::ln2, 2);
        const double value = whitened.restricted() - prior / 2;
        if (value > to_beat) {
            to_beat = step == 0 ? value + significant : value;
            best = {factor, whitened.chi2(), whitened.log_determinant, prior};
        }
    }
    return best;
}

namespace {

/// Sizes that are compared: from 0.05 % to 17 %, each a quarter larger than the one before.
constexpr double least_size = 0.0005, larger = 1.25;
constexpr int sizes = 27;  // up to 0.0005 x 1.25^26 = 0.17

}  // namespace

double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions) {
    const Eigen::MatrixXd errors = measured.covariance + prediction.covariance;
    const Eigen::MatrixXd unit = discrepancy_covariance(conditions, prediction.value, {1, 0});
    const Eigen::VectorXd residuals = measured.value - prediction.value;
    const double exact = restricted_log_likelihood(errors, residuals, prediction.jacobian);
    double best = 0, highest = exact + significant;
    for (int k = 0; k < sizes; ++k) {
        const double size = least_size * std::pow(larger, k);
        const double value =
            restricted_log_likelihood(errors + size * size * unit, residuals, prediction.jacobian);
        if (value > highest) {
            highest = value;
            best = size;
        }
    }
    return best;
}

}  // namespace pendular
