// Score tests of linear models against refits by the normal equations.
#include "analysis/diagnosis/score_statistic.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "tests/support/statistics_support.h"

namespace pendular::analysis_score_statistic_test {

using boost::math::cdf;
using boost::math::chi_squared;
using boost::math::complement;
using boost::math::normal;

/// Weighted least squares by the normal equations, as textbooks have it.
struct Refit {
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance;
    double chi2 = 0;

    Refit(const Eigen::MatrixXd& columns, const Measured& measured) {
        const Eigen::MatrixXd weights = measured.covariance.inverse();
        covariance = (columns.transpose() * weights * columns).inverse();
        parameters = covariance * columns.transpose() * weights * measured.value;
        const Eigen::VectorXd left = measured.value - columns * parameters;
        chi2 = left.dot(weights * left);
    }
};

Eigen::MatrixXd beside(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) {
    Eigen::MatrixXd both(left.rows(), left.cols() + right.cols());
    both << left, right;
    return both;
}

/// 12 correlated readings of a linear model with two parameters, and a change it does not make.
/// Matrices of order 1 and conditions of some 100: differences between two ways to compute a
/// result are below 1e-12.
class ScoreStatistic : public testing::Test {
  protected:
    static constexpr Eigen::Index entries = 12;

    const Eigen::MatrixXd base = normal_matrix(entries, 2, 1);
    const Eigen::VectorXd change = normal_matrix(entries, 1, 2);
    const Measured measured{
        .value = 3 * base.col(0) - base.col(1) + 2 * change + normal_matrix(entries, 1, 3),
        .covariance = some_covariance(entries, 4)};

    WeightedResiduals residuals_at(const Eigen::VectorXd& parameters) const {
        return {measured, exact_prediction(base * parameters, base)};
    }
    WeightedResiduals fitted() const { return residuals_at(Refit(base, measured).parameters); }
};

constexpr double rounding = 1e-11;

TEST_F(ScoreStatistic, EqualsTheDropOfARefit) {
    const ScoreTest test = score_test(fitted(), {.change = change}, false);
    const Refit without(base, measured), with(beside(base, change), measured);
    EXPECT_NEAR(test.statistic, without.chi2 - with.chi2, rounding);
    EXPECT_EQ(test.predicted_reduction, test.statistic);
    ASSERT_EQ(test.estimate.size(), 1);
    EXPECT_NEAR(test.estimate(0), with.parameters(2), rounding);
    EXPECT_NEAR(test.standard_error, std::sqrt(with.covariance(2, 2)), rounding);
    EXPECT_NEAR(test.length, 1 / with.covariance(2, 2), rounding);
    EXPECT_EQ(test.information, test.length);
    EXPECT_NEAR(test.p(), cdf(complement(chi_squared(1), without.chi2 - with.chi2)), rounding);
}

TEST_F(ScoreStatistic, DoesNotDependOnWhereTheParametersAre) {
    const ScoreTest there = score_test(fitted(), {.change = change}, false);
    const ScoreTest away =
        score_test(residuals_at(Eigen::Vector2d(-7, 11)), {.change = change}, false);
    EXPECT_NEAR(away.statistic, there.statistic, rounding);
    EXPECT_NEAR(away.estimate(0), there.estimate(0), rounding);
}

TEST_F(ScoreStatistic, IsOfWhatTheParametersCannotImitate) {
    const Eigen::VectorXd more = change + base * Eigen::Vector2d(0.7, -1.3);
    const ScoreTest plain = score_test(fitted(), {.change = change}, false);
    const ScoreTest mixed = score_test(fitted(), {.change = more}, false);
    EXPECT_NEAR(mixed.statistic, plain.statistic, rounding);
    EXPECT_NEAR(mixed.estimate(0), plain.estimate(0), rounding);
    EXPECT_NEAR(mixed.standard_error, plain.standard_error, rounding);
    EXPECT_GT(std::abs(mixed.share_imitated - plain.share_imitated), 0.01);
}

TEST_F(ScoreStatistic, ScalesWithTheUnitOfTheAmplitude) {
    const ScoreTest plain = score_test(fitted(), {.change = change}, false);
    const ScoreTest tenfold = score_test(fitted(), {.change = -10 * change}, false);
    EXPECT_NEAR(tenfold.statistic, plain.statistic, rounding);
    EXPECT_NEAR(tenfold.estimate(0), -plain.estimate(0) / 10, rounding);
    EXPECT_NEAR(tenfold.standard_error, plain.standard_error / 10, rounding);
}

TEST_F(ScoreStatistic, OfAnImitatedChangeIsNotSeen) {
    const ScoreTest test =
        score_test(fitted(), {.change = base * Eigen::Vector2d(0.7, -1.3)}, false);
    EXPECT_FALSE(test.seen());
    EXPECT_EQ(test.share_imitated, 1);
    EXPECT_EQ(test.p(), 1);
    EXPECT_TRUE(std::isinf(test.detectable(0.8, 0.05)));
}

TEST(ScoreStatisticInThePlane, IsThatOfTheComponentAcrossTheParameter) {
    // J = e1, g = (cos a, sin a), r = (0, r2), errors 1: P g = (0, sin a), so that the estimate is
    // r2/sin a with an error of 1/sin a, the statistic r2^2, and the parameter imitates cos^2 a.
    constexpr double a = 0.4, r2 = 1.7;
    const Measured measured{.value = Eigen::Vector2d(5, r2),
                            .covariance = Eigen::Matrix2d::Identity()};
    const WeightedResiduals residuals(
        measured, exact_prediction(Eigen::Vector2d(5, 0), Eigen::Vector2d(1, 0)));
    const Eigen::Vector2d g(std::cos(a), std::sin(a));
    const ScoreTest test = score_test(residuals, {.change = g}, false);
    EXPECT_NEAR(test.statistic, r2 * r2, 1e-14);
    EXPECT_NEAR(test.estimate(0), r2 / std::sin(a), 1e-14);
    EXPECT_NEAR(test.standard_error, 1 / std::sin(a), 1e-14);
    EXPECT_NEAR(test.share_imitated, std::cos(a) * std::cos(a), 1e-14);
    ASSERT_TRUE(test.seen());
    EXPECT_NEAR(std::abs(test.basis(1, 0)), 1, 1e-14);
}

TEST_F(ScoreStatistic, OfSeveralAmplitudesEqualsTheirJointRefit) {
    const Eigen::MatrixXd changes = beside(change, normal_matrix(entries, 1, 5));
    const ScoreTest test = score_test(fitted(), {.change = changes}, false);
    const Refit without(base, measured), with(beside(base, changes), measured);
    EXPECT_NEAR(test.statistic, without.chi2 - with.chi2, rounding);
    EXPECT_LT((test.estimate - with.parameters.tail(2)).norm(), rounding);
    EXPECT_EQ(test.basis.cols(), 2);
    EXPECT_NEAR(test.p(), cdf(complement(chi_squared(2), without.chi2 - with.chi2)), rounding);
}

TEST_F(ScoreStatistic, CountsAlikeChangesOnce) {
    const Eigen::VectorXd alike = -2 * change + 0.3 * base.col(0);
    const ScoreTest both = score_test(fitted(), {.change = beside(change, alike)}, false);
    const ScoreTest one = score_test(fitted(), {.change = change}, false);
    EXPECT_EQ(both.basis.cols(), 1);
    EXPECT_NEAR(both.statistic, one.statistic, rounding);
    EXPECT_NEAR(both.p(), one.p(), rounding);
}

TEST_F(ScoreStatistic, OfASwitchPredictsWhatTurningItOnBrings) {
    Measured less = measured;
    less.value -= change;
    const double drop = Refit(base, measured).chi2 - Refit(base, less).chi2;
    const ScoreTest test = score_test(fitted(), {.change = change, .one_sided = true}, true);
    EXPECT_NEAR(test.predicted_reduction, drop, rounding);
    // One that explains nothing makes the fit worse: 2 U - v is negative.
    const ScoreTest wrong = score_test(fitted(), {.change = -change, .one_sided = true}, true);
    EXPECT_LT(wrong.predicted_reduction, 0);
    EXPECT_EQ(wrong.statistic, 0);
}

TEST_F(ScoreStatistic, OfOneSignCountsThatSignOnly) {
    const ScoreTest both = score_test(fitted(), {.change = change}, false);
    const ScoreTest right = score_test(fitted(), {.change = change, .one_sided = true}, false);
    const ScoreTest wrong = score_test(fitted(), {.change = -change, .one_sided = true}, false);
    ASSERT_GT(both.estimate(0), 0);
    EXPECT_EQ(right.statistic, both.statistic);
    EXPECT_DOUBLE_EQ(right.p(), both.p() / 2);
    EXPECT_EQ(wrong.statistic, 0);
    EXPECT_EQ(wrong.p(), 1);
}

TEST_F(ScoreStatistic, IsCriticalWhereItsProbabilityIs) {
    for (const bool one_sided : {false, true}) {
        ScoreTest test = score_test(fitted(), {.change = change, .one_sided = one_sided}, false);
        for (const double p : {0.3, 0.05, 1e-6}) {
            test.statistic = test.critical(p);
            EXPECT_NEAR(test.p(), p, 1e-9 * p) << one_sided;
        }
    }
    // Chi2 of one degree of freedom at 5 %; a one-sided test has the normal quantile 1.645.
    const ScoreTest two = score_test(fitted(), {.change = change}, false);
    EXPECT_NEAR(two.critical(0.05), 3.8415, 1e-4);
    const ScoreTest one = score_test(fitted(), {.change = change, .one_sided = true}, false);
    EXPECT_NEAR(std::sqrt(one.critical(0.05)), 1.6449, 1e-4);
}

TEST_F(ScoreStatistic, HasThePowerOfANormalVariable) {
    // P g'r/sqrt(v) of a true amplitude A is normal about A sqrt(v) with variance 1.
    const ScoreTest two = score_test(fitted(), {.change = change}, false);
    const ScoreTest one = score_test(fitted(), {.change = change, .one_sided = true}, false);
    constexpr double limit = 0.05, amplitude = 0.8;
    const double away = amplitude * std::sqrt(two.length);
    const double z2 = quantile(normal(), 1 - limit / 2), z1 = quantile(normal(), 1 - limit);
    EXPECT_NEAR(two.power(amplitude, limit), cdf(normal(), away - z2) + cdf(normal(), -away - z2),
                1e-9);
    EXPECT_NEAR(one.power(amplitude, limit), cdf(normal(), away - z1), 1e-9);
    EXPECT_NEAR(two.power(0, limit), limit, 1e-9);
    // 80 % at 5 % takes v A^2 = (1.960 + 0.842)^2 = 7.85 (Saris).
    EXPECT_NEAR(std::pow(two.detectable(0.8, limit), 2) * two.length, 7.849, 1e-3);
    EXPECT_NEAR(one.power(one.detectable(0.8, limit), limit), 0.8, 1e-9);
}

TEST_F(ScoreStatistic, CountsErrorsOfTheModelAsThoseOfReadings) {
    // An error of the prediction that is left out of the measurement weighs the same.
    const Eigen::MatrixXd part = some_covariance(entries, 6) * 0.2;
    Measured less = measured;
    less.covariance -= part;
    Prediction prediction = exact_prediction(Eigen::VectorXd::Zero(entries), base);
    prediction.covariance = part;
    const ScoreTest split =
        score_test(WeightedResiduals(less, prediction), {.change = change}, false);
    const ScoreTest whole = score_test(fitted(), {.change = change}, false);
    EXPECT_NEAR(split.statistic, whole.statistic, rounding);
    EXPECT_NEAR(split.estimate(0), whole.estimate(0), rounding);
}

TEST(ScoreStatisticWithErrors, HasTheStatedCorrections) {
    // Errors of 2 in units of the readings, J = e1: P leaves entries 2 and 3. In whitened units
    // P g = (0, 1, 2), P r = (0, 3, -1), so that U = 1, v = 5. Covariances are divided by 4:
    //     b = -tr(P C_fg) = -(0.2 + 0.1) = -0.3,  v_c = 5 - (0.5 + 0.25) = 4.25,
    //     estimate = (U - b)/v_c = 1.3/4.25,  statistic = 1.3^2/5,
    //     g'P C_gg P g = 0.5 + 4 x 0.25 + 2 x 2 x 0.1 = 1.9.
    const Measured measured{.value = Eigen::Vector3d(8, 6, -2),
                            .covariance = 4 * Eigen::Matrix3d::Identity()};
    const WeightedResiduals residuals(
        measured, exact_prediction(Eigen::Vector3d::Zero(), Eigen::Vector3d(3, 0, 0)));
    Signature signature{.change = Eigen::Vector3d(1, 2, 4)};
    signature.errors.change =
        4 * Eigen::Matrix3d{{0.9, 0.3, 0.2}, {0.3, 0.5, 0.1}, {0.2, 0.1, 0.25}};
    signature.errors.with_without =
        4 * Eigen::Matrix3d{{0.7, 0.1, 0}, {0.4, 0.2, 0.3}, {0, -0.3, 0.1}};
    const ScoreTest test = score_test(residuals, signature, false);
    const double estimate = 1.3 / 4.25;
    EXPECT_NEAR(test.length, 5, 1e-13);
    EXPECT_NEAR(test.information, 4.25, 1e-13);
    EXPECT_NEAR(test.estimate(0), estimate, 1e-13);
    EXPECT_NEAR(test.statistic, 1.3 * 1.3 / 5, 1e-13);
    EXPECT_NEAR(test.standard_error, std::sqrt(5 + estimate * estimate * 1.9) / 4.25, 1e-13);
    const ScoreTest turned_on = score_test(residuals, signature, true);
    EXPECT_NEAR(turned_on.predicted_reduction, 2 * 1.3 - 4.25, 1e-13);
    // Power counts v_c alone: noncentrality A^2 v_c^2/v.
    const double away = 2 * 4.25 / std::sqrt(5), z = quantile(normal(), 0.975);
    EXPECT_NEAR(test.power(2, 0.05), cdf(normal(), away - z) + cdf(normal(), -away - z), 1e-9);
}

TEST(ScoreStatisticWithErrors, IsNotSeenWhereTheErrorsAreAllThereIs) {
    const Measured measured{.value = Eigen::Vector2d(3, 3),
                            .covariance = Eigen::Matrix2d::Identity()};
    const WeightedResiduals residuals(
        measured, exact_prediction(Eigen::Vector2d::Zero(), Eigen::Vector2d(1, 0)));
    Signature signature{.change = Eigen::Vector2d(0, 1)};
    signature.errors.change = 1.1 * Eigen::Matrix2d::Identity();
    signature.errors.with_without = Eigen::Matrix2d::Zero();
    const ScoreTest test = score_test(residuals, signature, false);
    EXPECT_FALSE(test.seen());
    EXPECT_EQ(test.p(), 1);
}

TEST(ScoreStatisticWithErrors, IsUnbiasedByThem) {
    // A model with errors e_f of its prediction and e_g of the change, correlated as in a finite
    // difference that shares f: e_g = e_h - e_f. With y = A g + e_y the mean of U - b is A g'P g,
    // that of v_c is g'P g. Without the corrections they would be off by tr(P C): six entries of
    // 0.3/0.8 and 0.6/0.8 in whitened units, 2.25 and 4.5. Means of 4000 draws lie within 3.3 of
    // their standard errors in 999 of 1000 cases.
    constexpr Eigen::Index n = 8;
    constexpr int draws = 4000;
    constexpr double variance = 0.3, amplitude = 0.7;
    const Eigen::MatrixXd base = normal_matrix(n, 2, 7);
    const Eigen::VectorXd change = 4 * normal_matrix(n, 1, 8);
    const Eigen::MatrixXd own = variance * Eigen::MatrixXd::Identity(n, n);
    Prediction prediction = exact_prediction(Eigen::VectorXd::Zero(n), base);
    prediction.covariance = own;
    Measured measured{.value = Eigen::VectorXd::Zero(n),
                      .covariance = 0.5 * Eigen::MatrixXd::Identity(n, n)};
    const Eigen::MatrixXd errors = normal_matrix(3 * n, draws, 9);
    const double v = score_test({measured, prediction}, {.change = change}, false).length;
    Eigen::VectorXd u(draws), information(draws);
    for (Eigen::Index draw = 0; draw < draws; ++draw) {
        const Eigen::VectorXd e = errors.col(draw);
        prediction.value = std::sqrt(variance) * e.head(n);
        measured.value = amplitude * change + std::sqrt(0.5) * e.tail(n);
        Signature signature{.change = change + std::sqrt(variance) * (e.segment(n, n) - e.head(n))};
        signature.errors.change = 2 * own;
        signature.errors.with_without = -own;
        const ScoreTest test = score_test({measured, prediction}, signature, false);
        // (U - b)^2/v and v_c, both of this draw.
        u(draw) = test.information > 0 ? test.estimate(0) * test.information : 0;
        information(draw) = test.information;
    }
    ASSERT_GT(information.minCoeff(), 0);  // none of them was left out
    const auto error = [](const Eigen::VectorXd& sample) {
        return 3.3 * std::sqrt((sample.array() - sample.mean()).square().sum()) / draws;
    };
    EXPECT_NEAR(u.mean(), amplitude * v, error(u));
    EXPECT_NEAR(information.mean(), v, error(information));
    EXPECT_LT(error(u), 1);
    EXPECT_LT(error(information), 2);
}

/// m independent scores of 8 readings whose errors are known: an entry each.
class FamilyOfScores : public testing::Test {
  protected:
    static constexpr Eigen::Index entries = 8, draws = 20000;

    const Measured measured{.value = Eigen::VectorXd::Zero(entries),
                            .covariance = some_covariance(entries, 10)};
    const WeightedResiduals residuals{
        measured, exact_prediction(Eigen::VectorXd::Zero(entries), Eigen::VectorXd::Zero(entries))};
    const NullDraws null_draws{measured, ErrorKnowledge::known(entries), 11, draws};

    /// Score tests of orthogonal directions in whitened units.
    std::vector<ScoreTest> independent(int count, bool one_sided = false) const {
        std::vector<ScoreTest> tests;
        for (Eigen::Index k = 0; k < count; ++k) {
            tests.push_back({.basis = Eigen::MatrixXd::Identity(entries, entries).col(k),
                             .statistic = 1,
                             .one_sided = one_sided});
        }
        return tests;
    }
};

TEST_F(FamilyOfScores, HasTheLeastOfIndependentProbabilities) {
    // P(any of m has p <= s) = 1 - (1 - s)^m, one-sided or not.
    for (const bool one_sided : {false, true}) {
        for (const int m : {1, 3, 8}) {
            const FamilyOfTests family(independent(m, one_sided), residuals, null_draws);
            for (const double s : {0.2, 0.05, 0.01}) {
                const double expected = 1 - std::pow(1 - s, m);
                EXPECT_NEAR(family.p(s), expected, binomial_error(expected, draws))
                    << m << ", " << s;
            }
        }
    }
}

TEST_F(FamilyOfScores, OfTheSameTestIsThatTest) {
    std::vector<ScoreTest> same(5, independent(1).front());
    const FamilyOfTests family(same, residuals, null_draws);
    EXPECT_NEAR(family.p(0.05), 0.05, binomial_error(0.05, draws));
}

TEST_F(FamilyOfScores, LimitsItsFalseAlarms) {
    // Sidak: 1 - (1 - a)^(1/m). The share of draws below it scatters by 1.5 % of a = 0.05 at
    // 20,000 draws, and the limit with it, about in proportion.
    const FamilyOfTests family(independent(8), residuals, null_draws);
    const double expected = 1 - std::pow(0.95, 1.0 / 8);
    const double error = binomial_error(0.05, draws) / 0.05;
    EXPECT_NEAR(family.limit(0.05), expected, (error + 0.001) * expected);
    EXPECT_NEAR(family.p(family.limit(0.05)), 0.05, 0.001);
}

TEST_F(FamilyOfScores, LeavesOutWhatIsNotSeen) {
    std::vector<ScoreTest> tests = independent(2);
    const double p = FamilyOfTests(tests, residuals, null_draws).p(0.05);
    tests.emplace_back();
    EXPECT_EQ(FamilyOfTests(tests, residuals, null_draws).p(0.05), p);
    EXPECT_EQ(FamilyOfTests({ScoreTest()}, residuals, null_draws).p(0.05), 1);
}

TEST_F(FamilyOfScores, DrawsTheLawOfItsStatistic) {
    // Two orthonormal columns: chi2 of two degrees of freedom.
    ScoreTest test;
    test.basis = Eigen::MatrixXd::Identity(entries, entries).middleCols(2, 2);
    EXPECT_LT(kolmogorov_distance(test.drawn(residuals, null_draws), chi_squared(2)),
              kolmogorov_limit);
    // One-sided: zero in half of the draws.
    const Eigen::VectorXd half = independent(1, true).front().drawn(residuals, null_draws);
    EXPECT_NEAR(static_cast<double>((half.array() == 0).count()) / draws, 0.5,
                binomial_error(0.5, draws));
}

TEST(WeightedResiduals, TakeNegativeEigenvaluesOfPredictionsForZero) {
    // Eigenvalues 0.06 and -0.04, as rounding leaves them where readings are nearly exact.
    const Measured measured{Eigen::Vector2d::Ones(), Eigen::Matrix2d::Identity(), {}};
    Prediction prediction{Eigen::Vector2d::Ones(), Eigen::MatrixXd::Ones(2, 1), {}, {}};
    prediction.covariance = Eigen::Matrix2d{{0.01, 0.05}, {0.05, 0.01}};
    const Eigen::MatrixXd root = WeightedResiduals(measured, prediction).prediction_root();
    EXPECT_NEAR((root * root.transpose()).trace(), 0.06 / 1.06, 1e-9);  // whitened, of the first
}

}  // namespace pendular::analysis_score_statistic_test
