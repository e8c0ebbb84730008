// The likelihood of hyperparameters: its value in closed form, its gradient against differences,
// its maximum where truth was planted.
#include "calib/emulator/gaussian_process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/support/kernel_support.h"

namespace pendular::calib_fit_hyperparameters_test {

Observations observed(const std::vector<Coordinates>& at, const Eigen::VectorXd& values,
                      double variance) {
    return {.at = at,
            .values = values,
            .noise = {at.size(), Eigen::MatrixXd::Constant(1, 1, variance)}};
}

double cost(const Observations& known, const Hyperparameters& hyperparameters, Domain domain,
            double unit) {
    return hyperparameter_cost(domain, known, unit, hyperparameters, nullptr);
}

TEST(HyperparameterCost, IsTheLikelihoodOfTwoValues) {
    // Two places of bridges with variance v each and covariance c:
    //     -ln L = (v y1^2 - 2 c y1 y2 + v y2^2)/(2 (v^2 - c^2)) + ln(v^2 - c^2)/2 + constant.
    // At equal hyperparameters the prior is the same, so that differences are of the likelihood
    // alone. v = A^2 + f n + b^2 + 25 (1 + u^2) at x = q = v = 0; the distance is along v, whose
    // polynomial term has the factor of both v.
    const Hyperparameters s = uneven_hyperparameters();
    constexpr double n = 0.02, u = 0.3;
    const auto likelihood = [&](double y1, double y2, double apart) {
        const double a2 = s.wet_amplitude * s.wet_amplitude, linear = 25 * (1 + u * u);
        const double noise = s.noise * n + s.between_run_scatter * s.between_run_scatter;
        const double v1 = a2 + linear + noise, v2 = v1 + 25 * apart * apart;
        const double c = linear + a2 * std::exp(-apart * apart / (2 * s.wet_v * s.wet_v));
        const double determinant = v1 * v2 - c * c;
        return (v2 * y1 * y1 - 2 * c * y1 * y2 + v1 * y2 * y2) / (2 * determinant) +
               std::log(determinant) / 2;
    };
    const auto computed = [&](double y1, double y2, double apart) {
        return cost(observed({{.u = u}, {.u = u, .v = apart}}, Eigen::Vector2d(y1, y2), n), s,
                    Domain::bridges, 1);
    };
    const double offset = computed(0, 0, 0.5) - likelihood(0, 0, 0.5);  // the prior's
    EXPECT_NEAR(computed(1, -2, 0.5), likelihood(1, -2, 0.5) + offset, 1e-11);
    EXPECT_NEAR(computed(0, 0, 2), likelihood(0, 0, 2) + offset, 1e-12);
    EXPECT_NEAR(computed(0.4, 0.7, 0.01), likelihood(0.4, 0.7, 0.01) + offset, 1e-11);
}

TEST(HyperparameterCost, HasALogNormalPrior) {
    // Far apart and at y = 0 a value says nothing of a length: the cost along it is a parabola in
    // its logarithm, with the stated deviation of 0.7 about the length 1.
    const Observations one = observed({{.x = 0.5, .u = 0.3}}, Eigen::VectorXd::Zero(1), 0.02);
    Hyperparameters s = uneven_hyperparameters();
    s.wet_x = 1;
    const double least = cost(one, s, Domain::bridges, 1);
    for (const double off : {-1.0, 0.5, 2.0}) {
        s.wet_x = std::exp(off);
        EXPECT_NEAR(cost(one, s, Domain::bridges, 1) - least, 0.5 * std::pow(off / 0.7, 2), 1e-12);
    }
}

class EachDomain : public testing::TestWithParam<Domain> {};

INSTANTIATE_TEST_SUITE_P(HyperparameterCost, EachDomain,
                         testing::Values(Domain::all_flow, Domain::contacts, Domain::bridges),
                         [](const auto& each) { return name_of(each.param); });

TEST_P(EachDomain, HasTheStatedGradient) {
    // Central differences of step 1e-4 in the logarithms: h^2/6 = 2e-9 of third derivatives of the
    // order of the cost, some 100 with values this far from what the hyperparameters would make.
    constexpr double step = 1e-4, tolerance = 1e-5;
    auto at = scattered_places(12, 1);
    at.push_back({.x = 0.2, .q = 0.1, .u = 0, .v = 0});
    const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(
        13, [](Eigen::Index k) { return 0.3 * std::sin(static_cast<double>(k * k)); });
    const Observations known = observed(at, values, 0.003);
    std::array<double, Hyperparameters::count> gradient;
    hyperparameter_cost(GetParam(), known, 0.5, uneven_hyperparameters(), gradient.data());
    for (std::size_t k = 0; k < Hyperparameters::count; ++k) {
        const auto moved_cost = [&](double off) {
            auto hyperparameters = uneven_hyperparameters().as_array();
            hyperparameters[k] *= std::exp(off);
            return cost(known, Hyperparameters::from_array(hyperparameters), GetParam(), 0.5);
        };
        EXPECT_NEAR(gradient[k], (moved_cost(step) - moved_cost(-step)) / (2 * step), tolerance)
            << Hyperparameters::names[k];
    }
}

TEST_P(EachDomain, IsLeastForTheLearnedScales) {
    // The search ends where the cost changes by less than 1e-7 of itself, so no scale may be wrong
    // by a percent to any gain worth mention.
    const auto at = scattered_places(25, 2);
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(25, [&](Eigen::Index k) {
        const Coordinates& place = at[static_cast<std::size_t>(k)];
        return 0.5 + 0.2 * place.x + place.u * std::sin(place.v) + 0.02 * normal(random);
    });
    const Observations known = observed(at, values, 4e-4);
    const Hyperparameters learned = fit_hyperparameters(GetParam(), known, 0.5);
    const double least = cost(known, learned, GetParam(), 0.5);
    EXPECT_LT(least, cost(known, uneven_hyperparameters(), GetParam(), 0.5));
    for (std::size_t k = 0; k < Hyperparameters::count; ++k) {
        for (const double factor : {0.9, 1.1}) {
            auto hyperparameters = learned.as_array();
            hyperparameters[k] *= factor;
            EXPECT_GT(cost(known, Hyperparameters::from_array(hyperparameters), GetParam(), 0.5),
                      least - 1e-4)
                << Hyperparameters::names[k] << " x " << factor;
        }
    }
}

TEST(FitHyperparameters, FindTheScatterBetweenRuns) {
    // 60 pairs, with errors of 0.001 stated and 0.02 there: the differences within pairs alone tell
    // the scatter to 1/sqrt(2 x 60) = 9 %. Limits of 3 of these.
    std::vector<Coordinates> at;
    for (const Coordinates& place : scattered_places(60, 4))
        at.insert(at.end(), 2, place);
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const Eigen::VectorXd values =
        Eigen::VectorXd::NullaryExpr(std::ssize(at), [&](Eigen::Index k) {
            const Coordinates& place = at[static_cast<std::size_t>(k)];
            return 0.5 + 0.2 * place.x + 0.1 * place.u + 0.02 * normal(random);
        });
    const Hyperparameters learned =
        fit_hyperparameters(Domain::all_flow, observed(at, values, 1e-6), 0.5);
    EXPECT_NEAR(learned.between_run_scatter, 0.02, 3 * 0.02 / std::sqrt(2 * 60.0));
}

TEST(FitHyperparameters, NeedRuns) {
    EXPECT_THROW(fit_hyperparameters(Domain::all_flow, {}, 1), std::invalid_argument);
}

}  // namespace pendular::calib_fit_hyperparameters_test
