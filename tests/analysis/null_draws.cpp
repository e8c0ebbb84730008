// Laws of the drawn errors against those of Boost.Math, each at a significance of 0.001 and with a
// fixed seed.
#include "analysis/misfit/null_draws.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/statistics_support.h"

namespace pendular::analysis_null_draws_test {

using boost::math::chi_squared;
using boost::math::fisher_f;
using boost::math::normal;
using boost::math::students_t;

constexpr Eigen::Index draws = 4000;

Measured zeros(const Eigen::MatrixXd& covariance) {
    return {.value = Eigen::VectorXd::Zero(covariance.rows()), .covariance = covariance};
}

/// Without parameters: residuals are the errors.
WeightedResiduals nothing_fitted(const Measured& measured) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(measured.value.size());
    return {measured, exact_prediction(zero, zero)};
}

/// Sums of squares of the columns.
Eigen::VectorXd squares(const Eigen::MatrixXd& columns) {
    return columns.colwise().squaredNorm().transpose();
}

TEST(NullDraws, OfKnownErrorsAreNormal) {
    // In whitened units: chi2 of n degrees of freedom, p fewer once p parameters are projected out.
    const Measured measured = zeros(some_covariance(6, 1));
    const NullDraws known(measured, ErrorKnowledge::known(6), 2, draws);
    const Eigen::MatrixXd whitened = known.whitened(nothing_fitted(measured));
    EXPECT_LT(kolmogorov_distance(squares(whitened), chi_squared(6)), kolmogorov_limit);
    EXPECT_LT(kolmogorov_distance(whitened.row(2).transpose(), normal()), kolmogorov_limit);
    const WeightedResiduals fitted(
        measured, exact_prediction(Eigen::VectorXd::Zero(6), normal_matrix(6, 2, 3)));
    EXPECT_LT(kolmogorov_distance(squares(fitted.project(known.whitened(fitted))), chi_squared(4)),
              kolmogorov_limit);
}

TEST(NullDraws, AreIndependentInWhitenedUnits) {
    // Means of products of N pairs scatter by 1/sqrt(N), those of squares by sqrt(2/N); 4.5 of
    // these for the largest of 21.
    const Measured measured = zeros(some_covariance(6, 1));
    const NullDraws known(measured, ErrorKnowledge::known(6), 4, draws);
    const Eigen::MatrixXd whitened = known.whitened(nothing_fitted(measured));
    const Eigen::MatrixXd products = whitened * whitened.transpose() / draws;
    EXPECT_LT((products - Eigen::MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(),
              4.5 * std::sqrt(2.0 / draws));
}

TEST(NullDraws, HoldErrorsOfThePrediction) {
    // In units of both together they make chi2 of n degrees of freedom again.
    const Measured measured = zeros(some_covariance(6, 5));
    Prediction prediction = exact_prediction(Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6));
    prediction.covariance = 2 * some_covariance(6, 6);
    const NullDraws known(measured, ErrorKnowledge::known(6), 7, draws);
    const WeightedResiduals residuals(measured, prediction);
    EXPECT_LT(kolmogorov_distance(squares(known.whitened(residuals)), chi_squared(6)),
              kolmogorov_limit);
    // Without them the mean square would be lower: measurement is some third of the whole.
    EXPECT_LT(squares(known.whitened(residuals)).mean(), 6.4);
}

TEST(NullDraws, AlongABasisAreTheirProductsWithIt) {
    const Measured measured = zeros(some_covariance(6, 8));
    Prediction prediction = exact_prediction(Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6));
    prediction.covariance = some_covariance(6, 9);
    const WeightedResiduals residuals(measured, prediction);
    const NullDraws known(measured, ErrorKnowledge::known(6), 10, 20);
    const Eigen::MatrixXd basis = normal_matrix(6, 2, 11);
    EXPECT_LT((known.along(residuals, basis) - basis.transpose() * known.whitened(residuals))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
}

TEST(NullDraws, OfOneEstimatedVarianceAreFisherDistributed) {
    // Errors z sqrt(nu/chi2_nu) with one chi2 for all entries: chi2/n is F of n and nu degrees of
    // freedom, each entry is Student's t.
    constexpr double freedom = 5;
    const Measured measured = zeros(3 * Eigen::MatrixXd::Identity(6, 6));
    ErrorKnowledge knowledge = ErrorKnowledge::known(6);
    knowledge.freedom = {freedom};
    const NullDraws estimated(measured, knowledge, 12, draws);
    const Eigen::MatrixXd whitened = estimated.whitened(nothing_fitted(measured));
    EXPECT_LT(kolmogorov_distance(squares(whitened) / 6, fisher_f(6, freedom)), kolmogorov_limit);
    EXPECT_LT(kolmogorov_distance(whitened.row(4).transpose(), students_t(freedom)),
              kolmogorov_limit);
    EXPECT_GT(kolmogorov_distance(squares(whitened), chi_squared(6)), kolmogorov_limit);
}

TEST(NullDraws, OfSeveralKindsAreUncertainByThemselves) {
    // Three entries of a kind with nu = 4, three of one with nu = 30: F of 3 and nu each, and no
    // correlation between the ranks of the two sums of squares (1/sqrt(N), 3.3 of it).
    const Measured measured = zeros(Eigen::MatrixXd::Identity(6, 6));
    ErrorKnowledge knowledge = ErrorKnowledge::known(6);
    knowledge.kind = {0, 1, 0, 1, 0, 1};
    knowledge.freedom = {4, 30};
    const Eigen::MatrixXd whitened =
        NullDraws(measured, knowledge, 13, draws).whitened(nothing_fitted(measured));
    const std::vector<Eigen::Index> even = {0, 2, 4}, odd = {1, 3, 5};
    const Eigen::VectorXd few = squares(whitened(even, Eigen::all)) / 3,
                          many = squares(whitened(odd, Eigen::all)) / 3;
    const fisher_f law_of_few(3, 4), law_of_many(3, 30);
    EXPECT_LT(kolmogorov_distance(few, law_of_few), kolmogorov_limit);
    EXPECT_LT(kolmogorov_distance(many, law_of_many), kolmogorov_limit);
    double correlation = 0;
    for (Eigen::Index k = 0; k < draws; ++k) {
        correlation += 12 * (cdf(law_of_few, few(k)) - 0.5) * (cdf(law_of_many, many(k)) - 0.5);
    }
    EXPECT_LT(std::abs(correlation / draws), 3.3 / std::sqrt(draws));
}

/// n entries with errors of variance 1, plus one that all of them share.
Measured with_a_shared_error(double variance, Eigen::Index n = 4) {
    return zeros(Eigen::MatrixXd::Identity(n, n) + variance * Eigen::MatrixXd::Ones(n, n));
}

ErrorKnowledge knowing(const SharedErrors& shared, Eigen::Index n = 4) {
    ErrorKnowledge knowledge = ErrorKnowledge::known(n);
    knowledge.shared = {shared};
    return knowledge;
}

TEST(NullDraws, OfAKnownSharedErrorHaveTheStatedCovariance) {
    const Measured measured = with_a_shared_error(2);
    const NullDraws known(
        measured, knowing({.loadings = Eigen::MatrixXd::Ones(4, 1), .variance = 2}), 14, draws);
    EXPECT_LT(
        kolmogorov_distance(squares(known.whitened(nothing_fitted(measured))), chi_squared(4)),
        kolmogorov_limit);
}

TEST(NullDraws, OfASharedErrorEstimatedFromFewAreStudentDistributed) {
    // Nothing but the shared error: variance between/steps with nu degrees of freedom where nothing
    // scatters within. The entries' own errors are 1e-6 of it.
    constexpr double freedom = 3, between = 8, steps = 4;
    const Measured measured =
        zeros(1e-6 * Eigen::MatrixXd::Identity(4, 4) + 2 * Eigen::MatrixXd::Ones(4, 4));
    const NullDraws estimated(measured,
                              knowing({.loadings = Eigen::MatrixXd::Ones(4, 1),
                                       .variance = between / steps,
                                       .between = between,
                                       .within = 0,
                                       .freedom_between = freedom,
                                       .freedom_within = 10,
                                       .steps = steps}),
                              15, draws);
    // Along itself the whitened error is the shared one in units of its size.
    const WeightedResiduals residuals = nothing_fitted(measured);
    const Eigen::VectorXd direction = residuals.whiten(Eigen::VectorXd::Ones(4)).normalized();
    const Eigen::VectorXd along = estimated.along(residuals, direction).transpose();
    EXPECT_LT(kolmogorov_distance(along, students_t(freedom)), kolmogorov_limit);
}

TEST(NullDraws, LeaveOutASharedErrorThatScatterWithinExplains) {
    // max(0, between nu_b/chi2_b - within nu_w/chi2_w) is zero as often as
    //     (chi2_w/nu_w)/(chi2_b/nu_b) <= within/between,
    // an F of nu_w and nu_b. An entry with no error but the shared one is then exactly zero.
    constexpr double between = 3, within = 2, freedom_between = 4, freedom_within = 12;
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(1, 1, 1);
    const Measured measured = zeros(covariance);
    const NullDraws estimated(measured,
                              knowing({.loadings = Eigen::MatrixXd::Ones(1, 1),
                                       .variance = 1,
                                       .between = between,
                                       .within = within,
                                       .freedom_between = freedom_between,
                                       .freedom_within = freedom_within},
                                      1),
                              16, draws);
    const Eigen::MatrixXd whitened = estimated.whitened(nothing_fitted(measured));
    const double expected = cdf(fisher_f(freedom_within, freedom_between), within / between);
    EXPECT_NEAR(static_cast<double>((whitened.array() == 0).count()) / draws, expected,
                binomial_error(expected, draws));
}

TEST(NullDraws, OfAnEstimatedCorrelationScatterAfterFisher) {
    // Readings of two observables whose correlation was estimated as 0 with nu = 18: in a draw it
    // is tanh(z/4). atanh of that of 100 readings adds 1/97, so that over draws its mean is 0 and
    // its variance 1/16 + 1/97; of 2000 draws that is known to sqrt(2/2000), 3.3 of these.
    constexpr Eigen::Index readings = 100, count = 2000;
    const Measured measured = zeros(Eigen::MatrixXd::Identity(2 * readings, 2 * readings));
    ErrorKnowledge knowledge = ErrorKnowledge::known(2 * readings);
    knowledge.readings = readings;
    knowledge.correlation_freedom = 18;
    const Eigen::MatrixXd errors =
        NullDraws(measured, knowledge, 17, count).whitened(nothing_fitted(measured));
    Eigen::VectorXd transformed(count);
    for (Eigen::Index draw = 0; draw < count; ++draw) {
        const Eigen::VectorXd column = errors.col(draw);
        const Eigen::VectorXd a = column(Eigen::seqN(0, readings, 2)),
                              b = column(Eigen::seqN(1, readings, 2));
        transformed(draw) = std::atanh(a.dot(b) / (a.norm() * b.norm()));
    }
    const double expected = 1.0 / 16 + 1.0 / 97;
    EXPECT_NEAR(transformed.mean(), 0, 3.3 * std::sqrt(expected / count));
    EXPECT_NEAR(transformed.squaredNorm() / count, expected,
                3.3 * expected * std::sqrt(2.0 / count));
    // Variances stay: all n count entries are N(0, 1).
    EXPECT_NEAR(errors.bottomRows(1).squaredNorm() / count, 1, 3.3 * std::sqrt(2.0 / count));
}

TEST(NullDraws, OfAnUncertainLoadExponentAreOffByItsFactor) {
    // ln|z| of a normal z has variance pi^2/8; a factor exp(z' c) adds c^2 and leaves the mean. Its
    // fourth central moment is 3 (pi^2/8)^2 + pi^4/16, so that the variance of N draws is known to
    // about 2.3/sqrt(N) of pi^2/8 + c^2; 3.3 of these.
    constexpr double c = 0.8;
    const Measured measured = zeros(Eigen::MatrixXd::Identity(2, 2));
    ErrorKnowledge knowledge = ErrorKnowledge::known(2);
    knowledge.log_sizes = {Eigen::Vector2d(0, c)};
    const Eigen::MatrixXd errors =
        NullDraws(measured, knowledge, 18, draws).whitened(nothing_fitted(measured));
    const Eigen::ArrayXd logs = errors.row(1).array().abs().log().transpose();
    const double expected = std::numbers::pi * std::numbers::pi / 8 + c * c;
    EXPECT_NEAR((logs - logs.mean()).square().mean(), expected,
                3.3 * 2.3 * expected / std::sqrt(draws));
    EXPECT_LT(kolmogorov_distance(errors.row(0).transpose(), normal()), kolmogorov_limit);
}

TEST(NullDraws, AreTheSameForTheSameSeed) {
    const Measured measured = zeros(some_covariance(4, 19));
    const WeightedResiduals residuals = nothing_fitted(measured);
    const auto drawn = [&](std::uint64_t seed) {
        return NullDraws(measured, ErrorKnowledge::known(4), seed, 10).whitened(residuals);
    };
    EXPECT_EQ(drawn(1), drawn(1));
    EXPECT_NE(drawn(1), drawn(2));
}

TEST(NullDraws, CountWhatIsAsLargeAndTheObservation) {
    const Eigen::Vector4d drawn(1, 2, 2, 3);
    EXPECT_DOUBLE_EQ(NullDraws::p(0, drawn), 1);
    EXPECT_DOUBLE_EQ(NullDraws::p(2, drawn), 4.0 / 5);  // as large counts
    EXPECT_DOUBLE_EQ(NullDraws::p(2.5, drawn), 2.0 / 5);
    EXPECT_DOUBLE_EQ(NullDraws::p(4, drawn), 1.0 / 5);  // never zero
}

}  // namespace pendular::analysis_null_draws_test
