#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "analysis/misfit/weighted_residuals.h"

// Linear models with normal errors, and tests of random samples against distributions.
namespace pendular {

/// Returns a matrix of independent random numbers from the standard normal distribution.
inline Eigen::MatrixXd normal_matrix(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// Returns a random n x n covariance matrix with unequal variances of order 1 and correlations of
/// either sign.
inline Eigen::MatrixXd some_covariance(Eigen::Index n, std::uint64_t seed) {
    const Eigen::MatrixXd half = normal_matrix(n, n, seed);
    return half * half.transpose() / static_cast<double>(n) + 0.3 * Eigen::MatrixXd::Identity(n, n);
}

/// Returns the prediction of a model without errors: its covariances are zero.
/// @param jacobian derivatives of the values with respect to the parameters
inline Prediction exact_prediction(const Eigen::VectorXd& value, const Eigen::MatrixXd& jacobian) {
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(value.size(), value.size());
    return {value, jacobian, none, none};
}

/// Kolmogorov statistic [1]: largest distance between the cumulative distribution of a sample and
/// `distribution`, times the square root of the sample size. In 1 of 1000 samples that are drawn
/// from `distribution`, it exceeds 1.95.
template <typename Law>
double kolmogorov_distance(const Eigen::VectorXd& sample, const Law& distribution) {
    std::vector<double> sorted(sample.begin(), sample.end());
    std::ranges::sort(sorted);
    const auto n = static_cast<double>(sorted.size());
    double largest = 0;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const double expected = cdf(distribution, sorted[k]);
        largest = std::max({largest, static_cast<double>(k + 1) / n - expected,
                            expected - static_cast<double>(k) / n});
    }
    return largest * std::sqrt(n);
}
/// Critical value of the Kolmogorov statistic [1] at a significance of 0.001.
constexpr double kolmogorov_limit = 1.95;

/// Largest plausible difference [1] between the observed share of an event in random draws and its
/// probability: 3.3 standard deviations, which chance exceeds in 1 of 1000 cases, plus 1/`count`.
/// @param probability true probability of the event [1]
/// @param count number of draws
inline double binomial_error(double probability, double count) {
    return 3.3 * std::sqrt(probability * (1 - probability) / count) + 1 / count;
}

}  // namespace pendular
