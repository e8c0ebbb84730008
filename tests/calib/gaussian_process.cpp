// Posteriors of a few places in closed form, and derivatives against differences.
#include "calib/emulator/gaussian_process.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/support/kernel_support.h"

namespace pendular::calib_gaussian_process_test {

using Requested = GaussianProcess::Requested;

constexpr double amplitude = 0.3, length = 0.7;

/// A squared exponential alone: without polynomial, and moved along x only.
Kernel plain_kernel(double noise = 1, double between_run_scatter = 0) {
    return {Domain::bridges,
            {.wet_amplitude = amplitude,
             .wet_x = length,
             .noise = noise,
             .between_run_scatter = between_run_scatter},
            0};
}

double covariance_at(double distance) {
    return amplitude * amplitude * std::exp(-distance * distance / (2 * length * length));
}

Observations seen(const std::vector<double>& x, const std::vector<double>& y,
                  const std::vector<double>& variances) {
    Observations known{.at = {}, .values = Eigen::MatrixXd(std::ssize(x), 1), .noise = {}};
    for (std::size_t k = 0; k < x.size(); ++k) {
        known.at.push_back({.x = x[k]});
        known.values(static_cast<Eigen::Index>(k), 0) = y[k];
        known.noise.push_back(Eigen::MatrixXd::Constant(1, 1, variances[k]));
    }
    return known;
}

Requested value_at(double x) {
    return {0, {{.x = x}}};
}
Requested slope_at(double x) {
    return {0, {{.x = x}, 0}};
}

TEST(GaussianProcess, SharesOneNoisyValueWithItsNeighbours) {
    // y at 0 with variance n: mean k(x) y/(A^2 + n), covariance k(x - x') - k(x) k(x')/(A^2 + n);
    // the slope has k'(x) = -x k(x)/l^2 in place of k(x), and variance A^2/l^2 before.
    constexpr double y = 2, n = 0.05, x = 0.4, total = amplitude * amplitude + n;
    const GaussianProcess process({plain_kernel()}, seen({0}, {y}, {n}));
    const double k = covariance_at(x), slope = -x / (length * length) * k;
    const Eigen::VectorXd mean = process.mean({value_at(x), slope_at(x), value_at(0)});
    EXPECT_NEAR(mean(0), k * y / total, 1e-15);
    EXPECT_NEAR(mean(1), slope * y / total, 1e-15);
    EXPECT_NEAR(mean(2), amplitude * amplitude * y / total, 1e-15);
    const Eigen::MatrixXd covariance = process.covariance({value_at(x), slope_at(x), value_at(0)});
    const double a2 = amplitude * amplitude;
    EXPECT_NEAR(covariance(0, 0), a2 - k * k / total, 1e-15);
    EXPECT_NEAR(covariance(1, 1), a2 / (length * length) - slope * slope / total, 1e-15);
    EXPECT_NEAR(covariance(0, 1), -k * slope / total, 1e-15);
    EXPECT_NEAR(covariance(0, 2), k * n / total, 1e-15);
    EXPECT_NEAR(covariance(1, 2), slope * n / total, 1e-15);
}

TEST(GaussianProcess, WeighsTwoNoisyValues) {
    // (K + N)^-1 of two values by Cramer's rule.
    constexpr double y1 = 1.5, y2 = -0.5, n1 = 0.02, n2 = 0.07, apart = 0.5, x = 0.2;
    const GaussianProcess process({plain_kernel()}, seen({0, apart}, {y1, y2}, {n1, n2}));
    const double a2 = amplitude * amplitude, c = covariance_at(apart);
    const double v1 = a2 + n1, v2 = a2 + n2, determinant = v1 * v2 - c * c;
    const double k1 = covariance_at(x), k2 = covariance_at(apart - x);
    EXPECT_NEAR(process.mean({value_at(x)})(0),
                (k1 * (v2 * y1 - c * y2) + k2 * (v1 * y2 - c * y1)) / determinant, 1e-14);
    EXPECT_NEAR(process.covariance({value_at(x)})(0, 0),
                a2 - (k1 * k1 * v2 - 2 * k1 * k2 * c + k2 * k2 * v1) / determinant, 1e-14);
}

TEST(GaussianProcess, WidensTheStatedNoise) {
    // By the factor on variances, and by the variance between runs.
    constexpr double stated = 0.05, factor = 1.5, between_run_scatter = 0.2;
    const GaussianProcess widened({plain_kernel(factor, between_run_scatter)},
                                  seen({0}, {1}, {stated}));
    const GaussianProcess plain(
        {plain_kernel()},
        seen({0}, {1}, {factor * stated + between_run_scatter * between_run_scatter}));
    EXPECT_NEAR(widened.mean({value_at(0.3)})(0), plain.mean({value_at(0.3)})(0), 1e-15);
    EXPECT_NEAR(widened.covariance({slope_at(0.3)})(0, 0), plain.covariance({slope_at(0.3)})(0, 0),
                1e-15);
}

TEST(GaussianProcess, InterpolatesWithoutNoise) {
    // Half a length apart the matrix of five values has a condition of some 1e5: 1e-16 becomes
    // 1e-11.
    std::vector<double> x, y;
    for (int k = 0; k < 5; ++k) {
        x.push_back(0.5 * length * k);
        y.push_back(std::cos(x.back()));
    }
    const GaussianProcess process({plain_kernel()}, seen(x, y, std::vector<double>(5, 0.0)));
    for (std::size_t k = 0; k < x.size(); ++k) {
        EXPECT_NEAR(process.mean({value_at(x[k])})(0), y[k], 1e-10);
        EXPECT_NEAR(process.covariance({value_at(x[k])})(0, 0), 0, 1e-10);
    }
    EXPECT_GT(process.covariance({value_at(0.25 * length)})(0, 0), 1e-7);  // between them
}

TEST(GaussianProcess, IsThePriorFarFromWhatIsKnown) {
    const GaussianProcess process({plain_kernel()}, seen({0}, {2}, {0.01}));
    EXPECT_NEAR(process.mean({value_at(20 * length)})(0), 0, 1e-15);
    EXPECT_NEAR(process.covariance({value_at(20 * length)})(0, 0), amplitude * amplitude, 1e-15);
}

TEST(GaussianProcess, JoinsQuantitiesThroughTheNoiseOfARun) {
    // Two quantities, independent before, seen once at 0 with correlated noise: with
    //     M = [A1^2 + f1 n11, sqrt(f1 f2) n12; sqrt(f1 f2) n12, A2^2 + f2 n22]
    // the means are k_i(x) [M^-1 y]_i and their covariance is k_ii - k_i k_j [M^-1]_ij.
    constexpr double f1 = 1.3, f2 = 0.6, x = 0.4;
    const Hyperparameters narrow{
        .wet_amplitude = 0.5, .wet_x = 0.4, .noise = f2, .between_run_scatter = 0};
    Observations known{.at = {{.x = 0}}, .values = Eigen::RowVector2d(1, -2), .noise = {}};
    known.noise.emplace_back(Eigen::Matrix2d{{0.04, -0.02}, {-0.02, 0.03}});
    const GaussianProcess process({plain_kernel(f1), Kernel(Domain::bridges, narrow, 0)}, known);
    const double joint = -0.02 * std::sqrt(f1 * f2);
    const Eigen::Matrix2d inverse = Eigen::Matrix2d{
        {amplitude * amplitude + 0.04 * f1, joint},
        {joint, 0.25 + 0.03 * f2}}.inverse();
    const Eigen::Vector2d weights = inverse * Eigen::Vector2d(1, -2);
    const Eigen::Vector2d k(covariance_at(x), 0.25 * std::exp(-x * x / (2 * 0.16)));
    const Eigen::Vector2d prior(amplitude * amplitude, 0.25);
    const std::vector<Requested> requested = {{0, {{.x = x}}}, {1, {{.x = x}}}};
    const Eigen::VectorXd mean = process.mean(requested);
    const Eigen::MatrixXd covariance = process.covariance(requested);
    for (Eigen::Index i = 0; i < 2; ++i) {
        EXPECT_NEAR(mean(i), k(i) * weights(i), 1e-14);
        for (Eigen::Index j = 0; j < 2; ++j) {
            EXPECT_NEAR(covariance(i, j), (i == j ? prior(i) : 0) - k(i) * k(j) * inverse(i, j),
                        1e-14);
        }
    }
}

/// 1, x, x^2, q, x q, q^2 in a row for each place.
Eigen::MatrixXd dry_terms(const std::vector<Coordinates>& places) {
    Eigen::MatrixXd terms(std::ssize(places), 6);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double x = places[k].x, q = places[k].q;
        terms.row(static_cast<Eigen::Index>(k)) << 1, x, x * x, q, x * q, q * q;
    }
    return terms;
}

std::vector<Coordinates> dry_places(std::size_t count, std::uint64_t seed) {
    std::vector<Coordinates> places = scattered_places(count, seed);
    for (Coordinates& at : places)
        at.u = at.v = 0;
    return places;
}

/// A polynomial of dry flow whose coefficients are 0 +- 5, and nothing else.
const Kernel polynomial{
    Domain::all_flow, {.dry_amplitude = 0, .wet_amplitude = 0, .between_run_scatter = 0}, 1};

Observations with_noise(const std::vector<Coordinates>& at, const Eigen::VectorXd& values,
                        double variance) {
    return {.at = at,
            .values = values,
            .noise = {at.size(), Eigen::MatrixXd::Constant(1, 1, variance)}};
}

std::vector<Requested> all_values(const std::vector<Coordinates>& at) {
    std::vector<Requested> requested;
    for (const Coordinates& place : at)
        requested.push_back({0, {place}});
    return requested;
}

TEST(GaussianProcess, IsBayesianRegressionOnItsPolynomial) {
    // Without processes: coefficients C H'y/s^2 with covariance C = (H'H/s^2 + 1/25)^-1. The matrix
    // of values has a condition of 25 x 40/s^2 = 1e6: 1e-16 becomes 1e-10.
    constexpr double variance = 1e-3;
    const auto at = dry_places(40, 1), elsewhere = dry_places(5, 2);
    const Eigen::VectorXd y = Eigen::VectorXd::NullaryExpr(
        40, [&](Eigen::Index k) { return std::sin(static_cast<double>(k)); });
    const GaussianProcess process({polynomial}, with_noise(at, y, variance));
    const Eigen::MatrixXd h = dry_terms(at), there = dry_terms(elsewhere);
    const Eigen::MatrixXd covariance =
        (h.transpose() * h / variance + Eigen::MatrixXd::Identity(6, 6) / 25).inverse();
    const Eigen::VectorXd coefficients = covariance * h.transpose() * y / variance;
    EXPECT_LT((process.mean(all_values(elsewhere)) - there * coefficients).norm(), 1e-9);
    EXPECT_LT(
        (process.covariance(all_values(elsewhere)) - there * covariance * there.transpose()).norm(),
        1e-9);
}

TEST(GaussianProcess, FindsAPolynomialAgain) {
    // Coefficients c of 0 +- 5 are drawn to 0 by |c| s^2/(25 e), e the least eigenvalue of H'H.
    // With |c| = 2.7, e = 0.01 and s^2 = 1e-8 that is 1.1e-7. Far away, where the terms are of size
    // 10, it is ten times that.
    const auto at = dry_places(40, 3);
    Eigen::VectorXd coefficients(6);
    coefficients << 0.5, -1, 2, 0.3, -0.7, 1.1;
    const Eigen::MatrixXd h = dry_terms(at);
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(h.transpose() * h).eigenvalues()(0),
              0.01);
    const GaussianProcess process({polynomial}, with_noise(at, h * coefficients, 1e-8));
    const Coordinates far{.x = 3, .q = 0.8};
    EXPECT_NEAR(process.mean({{0, {far}}})(0), dry_terms({far}).row(0).dot(coefficients), 1.1e-6);
    // d/dx = c1 + 2 c2 x + c4 q.
    EXPECT_NEAR(process.mean({{0, {far, 0}}})(0), -1 + 2 * 2 * 3 - 0.7 * 0.8, 1.1e-6);
}

/// Two quantities known at 15 wet places with correlated noise.
class JointPosterior : public testing::Test {
  protected:
    static GaussianProcess process() {
        const auto at = scattered_places(15, 4);
        Observations known{.at = at, .values = Eigen::MatrixXd(15, 2), .noise = {}};
        for (Eigen::Index k = 0; k < 15; ++k) {
            const Coordinates& place = at[static_cast<std::size_t>(k)];
            known.values(k, 0) = std::sin(2 * place.x) + place.u * place.v;
            known.values(k, 1) = std::cos(place.x + 3 * place.q) - place.u;
            known.noise.emplace_back(Eigen::Matrix2d{{0.01, -0.004}, {-0.004, 0.006}});
        }
        return {{Kernel(Domain::all_flow, uneven_hyperparameters(), 0.2),
                 Kernel(Domain::contacts, uneven_hyperparameters(), 0.1)},
                known};
    }
    const GaussianProcess posterior = process();
    const std::vector<Coordinates> places = scattered_places(3, 5);
};

// Central differences of step 1e-4 are off by h^2/6 = 2e-9 times third derivatives of order 100,
// rounding by some 1e-14/h = 1e-10.
constexpr double step = 1e-4, tolerance = 1e-6;

TEST_F(JointPosterior, HasTheMeanOfADerivative) {
    for (const Coordinates& at : places) {
        for (const Eigen::Index quantity : {0, 1}) {
            for (int by = 0; by < coordinate_count; ++by) {
                const Eigen::VectorXd ends = posterior.mean(
                    {{quantity, {moved(at, by, step)}}, {quantity, {moved(at, by, -step)}}});
                EXPECT_NEAR(posterior.mean({{quantity, {at, by}}})(0),
                            (ends(0) - ends(1)) / (2 * step), tolerance)
                    << quantity << ", " << by;
            }
        }
    }
}

TEST_F(JointPosterior, HasTheCovarianceOfDerivativesWithAnything) {
    // A derivative is the limit of a difference, so its covariance with anything is the difference
    // of the covariances, of the other quantity too.
    std::vector<Requested> others;
    for (const Eigen::Index quantity : {0, 1}) {
        for (int derivative = Functional::value; derivative < coordinate_count; ++derivative) {
            others.push_back({quantity, {places[1], derivative}});
        }
    }
    const auto count = std::ssize(others);
    for (const Eigen::Index quantity : {0, 1}) {
        for (int by = 0; by < coordinate_count; ++by) {
            std::vector<Requested> requested = others;
            requested.push_back({quantity, {places[0], by}});
            requested.push_back({quantity, {moved(places[0], by, step)}});
            requested.push_back({quantity, {moved(places[0], by, -step)}});
            const Eigen::MatrixXd covariance = posterior.covariance(requested);
            EXPECT_LT((covariance.col(count) -
                       (covariance.col(count + 1) - covariance.col(count + 2)) / (2 * step))
                          .head(count)
                          .cwiseAbs()
                          .maxCoeff(),
                      tolerance)
                << quantity << ", " << by;
        }
    }
}

TEST_F(JointPosterior, DoesNotDependOnWhatElseIsAsked) {
    const std::vector<Requested> requested = {
        {0, {places[0]}}, {1, {places[0], 2}}, {0, {places[0], 1}}};
    const Eigen::VectorXd together = posterior.mean(requested);
    const Eigen::MatrixXd covariance = posterior.covariance(requested);
    EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-15);
    for (std::size_t k = 0; k < requested.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        EXPECT_EQ(posterior.mean({requested[k]})(0), together(i));
        EXPECT_NEAR(posterior.covariance({requested[k]})(0, 0), covariance(i, i), 1e-15);
    }
}

TEST_F(JointPosterior, IsNoSurerThanItsKnowledgeAllows) {
    // A covariance: no combination of values and derivatives has a negative variance.
    std::vector<Requested> requested;
    for (const Coordinates& at : places) {
        for (const Eigen::Index quantity : {0, 1}) {
            for (int derivative = Functional::value; derivative < coordinate_count; ++derivative)
                requested.push_back({quantity, {at, derivative}});
        }
    }
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(posterior.covariance(requested))
            .eigenvalues();
    EXPECT_GT(values.minCoeff(), -1e-13 * values.maxCoeff());
}

TEST(Observations, OfOneQuantityKeepItsOwnNoise) {
    Observations both{.at = {{.x = 1}}, .values = Eigen::RowVector2d(3, 4), .noise = {}};
    both.noise.emplace_back(Eigen::Matrix2d{{0.1, 0.2}, {0.2, 0.5}});
    const Observations second = both.only(1);
    EXPECT_EQ(second.at, both.at);
    EXPECT_EQ(second.values, Eigen::MatrixXd::Constant(1, 1, 4));
    EXPECT_EQ(second.noise.at(0), Eigen::MatrixXd::Constant(1, 1, 0.5));
}

}  // namespace pendular::calib_gaussian_process_test
