#include "analysis/misfit/null_draws.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "calib/emulator/wide_products.h"

namespace pendular {
namespace {

using Random = std::mt19937_64;

/// Random ratio nu/chi2_nu of a true variance to its estimate with nu degrees of freedom; 1 where
/// the variance is known.
double over_believed(double freedom, Random& random) {
    return std::isfinite(freedom) ? freedom / std::chi_squared_distribution<double>(freedom)(random)
                                  : 1.0;
}

double drawn_variance(const SharedErrors& shared, Random& random) {
    if (!std::isfinite(shared.freedom_between)) return shared.variance;
    const double between = shared.between * over_believed(shared.freedom_between, random);
    const double within = shared.within * over_believed(shared.freedom_within, random);
    return std::max(0.0, between - within) / shared.steps;
}

/// Square root of the covariance of the errors that entries do not share.
Eigen::MatrixXd own_root(const Measured& measured, const ErrorKnowledge& knowledge) {
    Eigen::MatrixXd own = measured.covariance;
    for (const SharedErrors& shared : knowledge.shared) {
        own -= shared.variance * shared.loadings * shared.loadings.transpose();
    }
    // In units of the errors, since stresses and solid fractions are of different sizes.
    const Eigen::VectorXd size = measured.covariance.diagonal().cwiseSqrt();
    const Eigen::MatrixXd scaled =
        size.cwiseInverse().asDiagonal() * own * size.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaled);
    return size.asDiagonal() * modes.eigenvectors() *
           modes.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
           modes.eigenvectors().transpose();
}

Eigen::MatrixXd normals(Eigen::Index rows, Random& random) {
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, 1, [&] { return normal(random); });
}

/// Correlates the independent errors of the two observables of each reading by a random
/// coefficient, as uncertain as the estimate of their correlation.
void correlate(const ErrorKnowledge& knowledge, Random& random,
               Eigen::Ref<Eigen::VectorXd> errors) {
    constexpr double fewest = 4;  // the variance 1/(nu - 2) must be positive and finite
    if (!std::isfinite(knowledge.correlation_freedom)) return;
    const double spread = 1 / std::sqrt(std::max(fewest, knowledge.correlation_freedom) - 2);
    const double off = std::tanh(spread * std::normal_distribution<double>()(random));
    for (Eigen::Index k = 0; k < knowledge.readings; ++k) {
        errors(2 * k + 1) = off * errors(2 * k) + std::sqrt(1 - off * off) * errors(2 * k + 1);
    }
}

}  // namespace

ErrorKnowledge ErrorKnowledge::known(Eigen::Index n) {
    ErrorKnowledge result;
    result.kind.assign(static_cast<std::size_t>(n), 0);
    result.freedom = {INFINITY};
    return result;
}

NullDraws::NullDraws(const Measured& measured, const ErrorKnowledge& knowledge, std::uint64_t seed,
                     Eigen::Index count)
    : errors_(measured.value.size(), count), predictions_(measured.value.size(), count) {
    Random random(seed);
    const Eigen::Index n = errors_.rows();
    const Eigen::MatrixXd root = own_root(measured, knowledge);
    for (Eigen::Index draw = 0; draw < count; ++draw) {
        errors_.col(draw) = normals(n, random);
        predictions_.col(draw) = normals(n, random);
        correlate(knowledge, random, errors_.col(draw));
    }
    errors_ = root * errors_;
    // Values that tell nothing scatter in no test.
    for (const Eigen::Index entry : measured.unknown)
        errors_.row(entry).setZero();
    for (Eigen::Index draw = 0; draw < count; ++draw) {
        std::vector<double> believed;
        for (const double freedom : knowledge.freedom) {
            believed.push_back(std::sqrt(over_believed(freedom, random)));
        }
        for (Eigen::Index k = 0; k < n; ++k) {
            errors_(k, draw) *= believed[knowledge.kind[static_cast<std::size_t>(k)]];
        }
        for (const Eigen::VectorXd& log_size : knowledge.log_sizes) {
            const double off = std::normal_distribution<double>()(random);
            errors_.col(draw).array() *= (off * log_size).array().exp();
        }
        for (const SharedErrors& shared : knowledge.shared) {
            errors_.col(draw) += std::sqrt(drawn_variance(shared, random)) *
                                 (shared.loadings * normals(shared.loadings.cols(), random));
        }
    }
}

Eigen::MatrixXd NullDraws::along(const WeightedResiduals& residuals, const Eigen::MatrixXd& basis,
                                 Eigen::Index draws) const {
    return transposed_product(residuals.whiten_basis(basis), errors_.leftCols(draws)) +
           transposed_product(residuals.prediction_root().transpose() * basis,
                              predictions_.leftCols(draws));
}

Eigen::MatrixXd NullDraws::whitened(const WeightedResiduals& residuals) const {
    return residuals.whiten(errors_) + residuals.prediction_root() * predictions_;
}

double NullDraws::p(double observed, const Eigen::VectorXd& drawn) {
    // The observed value counts as one more draw: no p value is 0, and tests at a level reject no
    // more often than it says, however few the draws.
    const auto as_large = (drawn.array() >= observed).count();
    return static_cast<double>(1 + as_large) / static_cast<double>(1 + drawn.size());
}

}  // namespace pendular
