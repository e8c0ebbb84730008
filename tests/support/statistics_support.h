#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "analysis/misfit/weighted_residuals.h"

// Linear models with normal errors, and tests of distributions.
namespace pendular {

inline Eigen::MatrixXd normal_matrix(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// A covariance with unequal variances of order 1 and correlations of either sign.
inline Eigen::MatrixXd some_covariance(Eigen::Index n, std::uint64_t seed) {
    const Eigen::MatrixXd half = normal_matrix(n, n, seed);
    return half * half.transpose() / static_cast<double>(n) + 0.3 * Eigen::MatrixXd::Identity(n, n);
}

/// A prediction without errors of its own.
inline Prediction exact_prediction(const Eigen::VectorXd& value, const Eigen::MatrixXd& jacobian) {
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(value.size(), value.size());
    return {value, jacobian, none, none};
}

/// Largest distance of the distribution of a sample from a law, times the root of its size.
/// Kolmogorov: above 1.95 in 1 of 1000 samples of that law.
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
constexpr double kolmogorov_limit = 1.95;  ///< at a significance of 0.001

/// 3.3 standard deviations of the share of `count` draws that an event of this probability has:
/// exceeded by chance in 1 of 1000 cases.
inline double binomial_error(double probability, double count) {
    return 3.3 * std::sqrt(probability * (1 - probability) / count) + 1 / count;
}

}  // namespace pendular
