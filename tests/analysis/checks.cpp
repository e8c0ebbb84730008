// Each check of a fit on residuals whose statistic and probability are known, and how often all of
// them together raise a false alarm.
#include "analysis/misfit/checks.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/statistics_support.h"

namespace pendular::analysis_checks_test {

constexpr Eigen::Index draws = 4000;

/// Values far above their errors of 1, so that what is in proportion to them is the same for all.
constexpr double level = 1e7;
/// Rounding error of that, with residuals of order 10.
constexpr double rounding = 1e-5;

/// Readings of one observable about a constant that was fitted, with these residuals.
struct Constant {
    Measured measured;
    EntryKinds kinds{.observables = {"stress"}, .parameters = {"constant"}, .replicated = true};
    std::vector<Covariate> covariates;
    ErrorKnowledge errors;
    Eigen::VectorXd slopes;

    explicit Constant(const Eigen::VectorXd& residuals)
        : measured{.value = residuals.array() + level,
                   .covariance = Eigen::MatrixXd::Identity(residuals.size(), residuals.size())},
          errors(ErrorKnowledge::known(residuals.size())),
          slopes(Eigen::VectorXd::Ones(residuals.size())) {
        kinds.observable.assign(static_cast<std::size_t>(residuals.size()), 0);
        for (Eigen::Index k = 0; k < residuals.size(); ++k)
            kinds.conditions.push_back({k});
    }

    /// The parameter is that of an entry of its own, so that nothing else is projected out.
    void let_nothing_be_imitated() {
        slopes.setZero();
        slopes(slopes.size() - 1) = 1;
        kinds.observables.emplace_back("other");
        kinds.observable.back() = 1;
    }
    void along(const std::string& name, const Eigen::VectorXd& values) {
        covariates.push_back({name, values});
    }
    Checks check(std::uint64_t seed = 1, Eigen::Index count = draws) const {
        const Eigen::VectorXd predicted = Eigen::VectorXd::Constant(slopes.size(), level);
        return check_fit({measured, exact_prediction(predicted, slopes)}, kinds, covariates,
                         {measured, errors, seed, count});
    }
};

std::vector<Check> of_kind(const Checks& checks, Check::Kind kind) {
    std::vector<Check> found;
    std::ranges::copy_if(checks.all, std::back_inserter(found),
                         [&](const Check& each) { return each.kind == kind; });
    return found;
}

Eigen::VectorXd counted(Eigen::Index n) {
    return Eigen::VectorXd::LinSpaced(n, 0, static_cast<double>(n - 1));
}

/// Five conditions of three replicates each, with these means, and residuals of -1, 0, 1 about
/// them.
Constant replicated(const std::vector<double>& means) {
    Eigen::VectorXd residuals(3 * std::ssize(means));
    for (Eigen::Index k = 0; k < residuals.size(); ++k) {
        residuals(k) = means[static_cast<std::size_t>(k / 3)] + static_cast<double>(k % 3) - 1;
    }
    Constant fit(residuals);
    fit.kinds.conditions.clear();
    for (Eigen::Index k = 0; k < residuals.size(); k += 3)
        fit.kinds.conditions.push_back({k, k + 1, k + 2});
    return fit;
}

TEST(Checks, FindTheLackOfFitOfMeans) {
    // The sum of n_i (mean_i - mean)^2 over conditions, chi2 of one degree of freedom less than
    // there are conditions; what scatters within them has no part in it.
    const Constant fit = replicated({1.2, -0.8, 0.3, -1.5, 0.8});
    const Check lack = of_kind(fit.check(), Check::Kind::lack_of_fit).at(0);
    const double expected = 3 * (1.44 + 0.64 + 0.09 + 2.25 + 0.64);  // the means add up to zero
    EXPECT_NEAR(lack.statistic, expected, rounding);
    const double p = cdf(complement(boost::math::chi_squared(4), expected));
    EXPECT_NEAR(lack.p, p, binomial_error(p, draws));
}

TEST(Checks, LetFewReplicatesWidenTheLawOfLackOfFit) {
    // With the variance known from nu differences the statistic over 4 is F of 4 and nu.
    Constant fit = replicated({1.2, -0.8, 0.3, -1.5, 0.8});
    fit.errors.freedom = {6};
    const Check lack = of_kind(fit.check(), Check::Kind::lack_of_fit).at(0);
    const double p = cdf(complement(boost::math::fisher_f(4, 6), 3 * 5.06 / 4));
    EXPECT_NEAR(lack.p, p, binomial_error(p, draws));
}

TEST(Checks, DoNotDependOnWhereTheParametersAre) {
    Constant fit = replicated({1.2, -0.8, 0.3, -1.5, 0.8});
    fit.along("x", counted(15));
    Constant off = fit;
    off.measured.value.array() += 7;
    const Checks there = fit.check(), away = off.check();
    ASSERT_EQ(there.all.size(), away.all.size());
    for (std::size_t k = 0; k < there.all.size(); ++k) {
        EXPECT_NEAR(away.all[k].statistic, there.all[k].statistic, 2 * rounding);
    }
}

/// -a for the first half of 100 entries, a for the second.
Eigen::VectorXd halves(double a, Eigen::Index n = 100) {
    Eigen::VectorXd result(n);
    result << Eigen::VectorXd::Constant(n / 2, -a), Eigen::VectorXd::Constant(n / 2, a);
    return result;
}

TEST(Checks, CumulateScoresLikeABrownianBridge) {
    // S reaches 50 a at the step, over a standard deviation of 10: 5 a. A bridge exceeds 1.358 with
    // probability 0.05 (Kolmogorov); a walk of n steps misses 0.583/sqrt(n) of its largest value on
    // the way (Siegmund), so that here the limit is 1.300. Beyond what draws scatter by, that
    // correction is good to 0.004.
    Constant fit(halves(0.26));
    fit.along("x", counted(100));
    const Check score = of_kind(fit.check(), Check::Kind::score).at(0);
    EXPECT_EQ(score.covariate, "x");
    EXPECT_EQ(score.of, "constant");
    EXPECT_NEAR(score.statistic, 1.3, rounding);
    EXPECT_NEAR(score.p, 0.05, binomial_error(0.05, draws) + 0.004);
}

TEST(Checks, CumulateScoresOverEqualValuesAtOnce) {
    // The order of entries of one value says nothing, and those without a value have no part: -5, 5
    // at the same place cancel, and what is left is -3 before 3, over a deviation of sqrt(6).
    Eigen::VectorXd residuals(6), x(6);
    residuals << -5, 5, -3, 3, 1, -1;
    x << 0, 0, 1, 2, NAN, NAN;
    Constant fit(residuals);
    fit.along("x", x);
    EXPECT_NEAR(of_kind(fit.check(), Check::Kind::score).at(0).statistic, 3 / std::sqrt(6.0),
                rounding);
}

TEST(Checks, FindATrendWithItsSign) {
    // Residuals a d along the unit vector d of ranks: the statistic is a, a standard normal
    // variable where there is no trend; p counts both signs. Ranks do not see how x grows.
    Eigen::VectorXd ranks = counted(15);
    ranks.array() -= 7;
    for (const double a : {1.8, -1.8}) {
        Constant fit(a * ranks.normalized());
        fit.along("x", counted(15).array().exp());
        const Check trend = of_kind(fit.check(), Check::Kind::trend).at(0);
        EXPECT_NEAR(trend.statistic, a, rounding);
        const double p = 2 * cdf(boost::math::normal(), -1.8);
        EXPECT_NEAR(trend.p, p, binomial_error(p, draws));
    }
}

TEST(Checks, FindATrendInOneObservableAlone) {
    Constant fit(Eigen::VectorXd::Zero(12));
    fit.kinds.observables = {"stress", "fraction"};
    Eigen::VectorXd x(12);
    for (Eigen::Index k = 0; k < 12; ++k) {
        fit.kinds.observable[static_cast<std::size_t>(k)] = static_cast<std::size_t>(k % 2);
        x(k) = static_cast<double>(k / 2);
        if (k % 2 == 1) fit.measured.value(k) += x(k) - 2.5;
    }
    fit.along("x", x);
    const auto trends = of_kind(fit.check(), Check::Kind::trend);
    ASSERT_EQ(trends.size(), 2u);
    EXPECT_EQ(trends[1].of, "fraction");
    EXPECT_NEAR(trends[0].statistic, 0, rounding);
    // The norm of (-2.5, -1.5, ..., 2.5).
    EXPECT_NEAR(trends[1].statistic, std::sqrt(17.5), rounding);
}

TEST(Checks, CountChangesOfSign) {
    // 21 residuals that nothing imitates change their sign from one to the next with probability
    // 1/2 each: the number of changes is binomial. Here there are 5 in 20.
    Eigen::VectorXd residuals(22);
    residuals << 1, 1, 1, 1, -1, -1, -1, -1, 1, 1, 1, 1, -1, -1, -1, -1, 1, 1, 1, -1, -1, 0;
    Constant fit(residuals);
    fit.let_nothing_be_imitated();
    fit.kinds.replicated = false;
    const auto runs = of_kind(fit.check(), Check::Kind::runs);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].statistic, -5);
    const double p = cdf(boost::math::binomial(20, 0.5), 5);
    EXPECT_NEAR(runs[0].p, p, binomial_error(p, draws));
    // With replicates their scatter says more.
    fit.kinds.replicated = true;
    EXPECT_TRUE(of_kind(fit.check(), Check::Kind::runs).empty());
}

TEST(Checks, FindNeighboursThatAreAlike) {
    // Two places with 10 entries each, ranks -1/2 and 1/2 apart: r'Kr = S1^2 + S2^2 + 2 k S1 S2
    // with the sums over places and k = exp(-1/(2 l^2)). (S1 +- S2)^2 are independent, so that it
    // is 10 [(1 + k) X^2 + (1 - k) Y^2] of normal X, Y, which exceeds t with probability
    //     1/(2 pi) int exp(-t/(20 [(1 + k) cos^2 + (1 - k) sin^2])) d(angle).
    Eigen::VectorXd residuals = Eigen::VectorXd::Constant(21, 0.6), x = Eigen::VectorXd::Zero(21);
    residuals.segment(10, 10).setConstant(0.4);
    residuals(20) = 0;
    x.segment(10, 10).setOnes();
    x(20) = NAN;
    Constant fit(residuals);
    fit.let_nothing_be_imitated();
    fit.along("x", x);
    const auto neighbours = of_kind(fit.check(), Check::Kind::neighbours);
    ASSERT_EQ(neighbours.size(), 3u);
    const std::array<double, 3> lengths = {0.3, 1, 3};
    for (std::size_t k = 0; k < 3; ++k) {
        const double alike = std::exp(-1 / (2 * lengths[k] * lengths[k]));
        const double statistic = 36 + 16 + 2 * alike * 24;
        EXPECT_NEAR(neighbours[k].statistic, statistic, 10 * rounding);
        double p = 0;
        constexpr int angles = 1000;
        for (int angle = 0; angle < angles; ++angle) {
            const double c = std::cos(2 * std::numbers::pi * angle / angles);
            p += std::exp(-statistic / (20 * (1 + alike * (2 * c * c - 1)))) / angles;
        }
        EXPECT_NEAR(neighbours[k].p, p, binomial_error(p, draws)) << lengths[k];
    }
}

TEST(Checks, CallAPerfectFitPerfect) {
    Constant fit(Eigen::VectorXd::Zero(15));
    fit.along("x", counted(15));
    EXPECT_GT(fit.check().p, 0.99);
}

TEST(Checks, AreNoSurerTogetherThanTheMostStriking) {
    Constant fit = replicated({1.2, -0.8, 0.3, -1.5, 0.8});
    fit.along("x", counted(15));
    const Checks checks = fit.check();
    const auto least = std::ranges::min_element(checks.all, {}, &Check::p);
    EXPECT_GT(checks.p, least->p);
    // Bonferroni's bound, with the resolution of the draws.
    EXPECT_LE(checks.p, static_cast<double>(checks.all.size()) * (least->p + 1.0 / draws));
}

TEST(Checks, RaiseFalseAlarmsAsOftenAsTheySay) {
    // 600 right models with errors known, or known from 4 differences: the global p is below 0.05
    // in 5 % of them, within what is exceeded by chance in 1 of 1000 cases. Were a variance from 4
    // differences taken for known, there would be some 25 %.
    constexpr int studies = 600;
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (const double freedom : {double{INFINITY}, 4.0}) {
        int alarms = 0;
        for (int study = 0; study < studies; ++study) {
            Constant fit(Eigen::VectorXd::NullaryExpr(12, [&] { return normal(random); }));
            fit.kinds.replicated = false;
            fit.along("x", counted(12));
            fit.errors.freedom = {freedom};
            if (std::isfinite(freedom)) {
                fit.measured.covariance *=
                    std::chi_squared_distribution<double>(freedom)(random) / freedom;
            }
            alarms += fit.check(static_cast<std::uint64_t>(study), 399).p <= 0.05;
        }
        EXPECT_NEAR(static_cast<double>(alarms) / studies, 0.05, binomial_error(0.05, studies))
            << freedom;
    }
}

}  // namespace pendular::analysis_checks_test
