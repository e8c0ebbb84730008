#include "analysis/diagnosis/likely_discrepancy.h"

#include <cmath>

#include "calib/fit/inexactness.h"
#include "calib/model/discrepancy.h"

namespace pendular {
namespace {

/// Sizes that are compared: from 0.05 % to 17 %, each a quarter larger than the one before.
constexpr double least = 0.0005, step = 1.25;
constexpr int sizes = 27;  // up to 0.0005 x 1.25^26 = 0.17

/// Smallest difference of the log likelihood at which an exact model is rejected, p = 0.05 with the
/// size at the bound of its range (half of chi2 with one degree of freedom beyond 2.71).
constexpr double significant = 2.71 / 2;

}  // namespace

double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions) {
    const Eigen::MatrixXd errors = measured.covariance + prediction.covariance;
    const Eigen::MatrixXd unit = discrepancy_covariance(conditions, prediction.value, {1, 0});
    const Eigen::VectorXd residuals = measured.value - prediction.value;
    const double exact = restricted_log_likelihood(errors, residuals, prediction.jacobian);
    double best = 0, highest = exact + significant;
    for (int k = 0; k < sizes; ++k) {
        const double size = least * std::pow(step, k);
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
