#include "analysis/diagnosis/likely_discrepancy.h"

#include <Eigen/Dense>
#include <cmath>

#include "calib/model/discrepancy.h"

namespace pendular {
namespace {

/// Sizes that are compared: from 0.05 % to 17 %, each a quarter larger than the one before.
constexpr double least = 0.0005, step = 1.25;
constexpr int sizes = 27;  // up to 0.0005 x 1.25^26 = 0.17

/// Smallest difference of the log likelihood at which an exact model is rejected, p = 0.05 with the
/// size at the bound of its range (half of chi2 with one degree of freedom beyond 2.71).
constexpr double significant = 2.71 / 2;

/// Restricted log likelihood of residuals with these derivatives, up to a constant.
double log_likelihood(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& residuals,
                      const Eigen::MatrixXd& derivatives) {
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    const auto lower = factor.matrixL();
    const Eigen::VectorXd r = lower.solve(residuals);
    const Eigen::MatrixXd j = lower.solve(derivatives);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(j);
    const Eigen::VectorXd turned = decomposed.householderQ().transpose() * r;
    const auto rank = decomposed.rank();
    const double log_volume = Eigen::MatrixXd(factor.matrixL()).diagonal().array().log().sum() +
                              decomposed.matrixQR().diagonal().head(rank).array().abs().log().sum();
    return -log_volume - turned.tail(turned.size() - rank).squaredNorm() / 2;
}

}  // namespace

double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions) {
    const Eigen::MatrixXd errors = measured.covariance + prediction.covariance;
    const Eigen::MatrixXd unit = discrepancy_covariance(conditions, prediction.value, {1, 0});
    const Eigen::VectorXd residuals = measured.value - prediction.value;
    const double exact = log_likelihood(errors, residuals, prediction.jacobian);
    double best = 0, highest = exact + significant;
    for (int k = 0; k < sizes; ++k) {
        const double size = least * std::pow(step, k);
        const double value =
            log_likelihood(errors + size * size * unit, residuals, prediction.jacobian);
        if (value > highest) {
            highest = value;
            best = size;
        }
    }
    return best;
}

}  // namespace pendular
