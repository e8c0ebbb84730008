#include "analysis/diagnosis/score_statistic.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "data/quantities/decompositions.h"
#include "data/quantities/statistics.h"

namespace pendular {
namespace {

/// Sets estimate, errors and statistic of a test of a change with one column, with the errors of
/// the change included.
void test_amplitude(ScoreTest& test, const WeightedResiduals& residuals, const Signature& signature,
                    const ColumnScores& column, bool is_switch) {
    const double length = column.lengths(0), v = length * length;
    double u = length * column.along(0), noise = 0;
    test.length = test.information = v;
    if (signature.errors.change.size() > 0) {
        u += residuals.trace_of_projected(signature.errors.with_without);
        test.information -= residuals.trace_of_projected(signature.errors.change);
        noise = std::max(0.0, residuals.variance_along(length * column.directions.col(0),
                                                       signature.errors.change));
    }
    if (test.information <= 0) {
        return;  // the change is not larger than its error
    }
    const double estimate = u / test.information;
    const double variance = v + estimate * estimate * noise;
    test.estimate = Eigen::VectorXd::Constant(1, estimate);
    test.standard_error = std::sqrt(variance) / test.information;
    test.statistic = test.one_sided && u < 0 ? 0.0 : u * u / v;
    test.predicted_reduction = is_switch ? 2 * u - test.information : test.statistic;
    test.basis = column.directions;
}

/// Sets estimates and statistic of a test of a change with several columns.
void test_amplitudes(ScoreTest& test, const WeightedResiduals& residuals,
                     const Eigen::MatrixXd& projected) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(projected);
    decomposed.setThreshold(1e-9);  // smaller directions are rounding of the projection
    test.basis = basis_of(decomposed);
    test.estimate = decomposed.solve(residuals.residuals());
    test.statistic = (test.basis.transpose() * residuals.residuals()).squaredNorm();
    test.predicted_reduction = test.statistic;
    test.length = test.information = projected.col(0).squaredNorm();
    test.standard_error = 1 / std::sqrt(test.information);
}

}  // namespace

ColumnScores score_columns(const WeightedResiduals& residuals, const Eigen::MatrixXd& changes,
                           double least_left) {
    const Eigen::MatrixXd whitened = residuals.whiten(changes);
    ColumnScores scores{.directions = residuals.project(whitened)};
    scores.lengths = scores.directions.colwise().norm();
    scores.imitated = Eigen::VectorXd::Ones(changes.cols());
    for (Eigen::Index k = 0; k < changes.cols(); ++k) {
        const double whole = whitened.col(k).norm(), left = scores.lengths(k);
        if (left > least_left * whole) {
            scores.directions.col(k) /= left;
            scores.imitated(k) = 1 - left * left / (whole * whole);
        } else {
            scores.directions.col(k).setZero();
            scores.lengths(k) = 0;
        }
    }
    scores.along = scores.directions.transpose() * residuals.residuals();
    return scores;
}

ScoreTest score_test(const WeightedResiduals& residuals, const Signature& signature,
                     bool is_switch) {
    ScoreTest test;
    test.one_sided = signature.one_sided;
    if (signature.change.cols() == 1) {
        const ColumnScores column = score_columns(residuals, signature.change);
        test.share_imitated = column.imitated(0);
        if (column.lengths(0) > 0) test_amplitude(test, residuals, signature, column, is_switch);
        return test;
    }
    const Eigen::MatrixXd whitened = residuals.whiten(signature.change);
    const Eigen::MatrixXd projected = residuals.project(whitened);
    const double whole = whitened.norm();
    test.share_imitated = 1;
    if (!(projected.norm() > rounding_share * whole)) return test;
    test.share_imitated = 1 - projected.squaredNorm() / (whole * whole);
    test_amplitudes(test, residuals, projected);
    return test;
}

double ScoreTest::p() const {
    if (!seen() || statistic <= 0) {
        return 1;
    }
    const double tail = chi_squared_tail(statistic, static_cast<double>(basis.cols()));
    return one_sided ? tail / 2 : tail;
}

double ScoreTest::critical(double limit) const {
    const double tail = one_sided ? 2 * limit : limit;
    if (tail >= 1) {
        return 0;
    }
    return chi_squared_exceeded_by(std::max(tail, 1e-300), static_cast<double>(basis.cols()));
}

Eigen::VectorXd ScoreTest::drawn(const WeightedResiduals& residuals, const NullDraws& draws) const {
    const Eigen::MatrixXd along = draws.along(residuals, basis);
    if (one_sided) {
        return along.cwiseMax(0.0).cwiseAbs2().transpose();
    }
    return along.colwise().squaredNorm().transpose();
}

double ScoreTest::power(double amplitude, double limit) const {
    const double away =
        length > 0 ? std::abs(amplitude) * std::max(0.0, information) / std::sqrt(length) : 0.0;
    const double needed = critical(limit);
    if (one_sided) {
        return normal_below(away - std::sqrt(needed));
    }
    return non_central_chi_squared_tail(
        needed, static_cast<double>(std::max<Eigen::Index>(1, basis.cols())), away * away);
}

double ScoreTest::detectable(double wanted, double limit) const {
    if (!(information > 0)) {
        return INFINITY;
    }
    // The other tail of the two-sided test is negligible at powers of interest.
    const double away = std::sqrt(critical(limit)) + normal_quantile(wanted);
    return away * std::sqrt(length) / information;
}

FamilyOfTests::FamilyOfTests(const std::vector<ScoreTest>& tests,
                             const WeightedResiduals& residuals, const NullDraws& draws) {
    std::ranges::copy_if(tests, std::back_inserter(tests_), &ScoreTest::seen);
    drawn_.resize(draws.count(), static_cast<Eigen::Index>(tests_.size()));
    for (std::size_t k = 0; k < tests_.size(); ++k) {
        drawn_.col(static_cast<Eigen::Index>(k)) = tests_[k].drawn(residuals, draws);
    }
}

double FamilyOfTests::p(double smallest) const {
    if (tests_.empty()) {
        return 1;
    }
    Eigen::Array<bool, Eigen::Dynamic, 1> any =
        Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(drawn_.rows(), false);
    for (std::size_t k = 0; k < tests_.size(); ++k) {
        any =
            any || drawn_.col(static_cast<Eigen::Index>(k)).array() >= tests_[k].critical(smallest);
    }
    return static_cast<double>(1 + any.count()) / static_cast<double>(1 + drawn_.rows());
}

double FamilyOfTests::limit(double probability) const {
    // Bisection: p() increases with its argument.
    double low = 1e-300, high = 1;
    for (int halving = 0; halving < 60 && high / low > 1.001; ++halving) {
        const double middle = std::sqrt(low * high);
        (p(middle) < probability ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

}  // namespace pendular
