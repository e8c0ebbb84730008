// The covariance of an emulated quantity against its formula, its own differences and the limits
// that physics demands.
#include "calib/emulator/kernel.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "tests/support/kernel_support.h"

namespace pendular::calib_kernel_test {

constexpr Coordinates one_place{.x = 0.2, .q = 0.1, .u = 0.3, .v = -0.4},
    other_place{.x = -0.5, .q = 0.25, .u = 0.8, .v = 0.6};

/// exp(-d^2/(2 l^2)).
double bell(double distance, double length) {
    return std::exp(-distance * distance / (2 * length * length));
}

/// The length of the reduced pressure is in ln(1 + u/0.1).
double pressure_scale(double u) {
    return std::log(1 + u / 0.1);
}

double dry_process(const Hyperparameters& s, const Coordinates& a, const Coordinates& b) {
    return s.dry_amplitude * s.dry_amplitude * bell(a.x - b.x, s.dry_x) * bell(a.q - b.q, s.dry_q);
}

/// Covariance of g_wet alone, without the factors that make it vanish for dry grains.
double wet_process(const Hyperparameters& s, const Coordinates& a, const Coordinates& b) {
    return s.wet_amplitude * s.wet_amplitude * bell(a.x - b.x, s.wet_x) * bell(a.q - b.q, s.wet_q) *
           bell(pressure_scale(a.u) - pressure_scale(b.u), s.wet_u) * bell(a.v - b.v, s.wet_v);
}

/// Sum of the products of the terms 1, x, x^2, q, x q, q^2.
double dry_polynomial(const Coordinates& a, const Coordinates& b) {
    return 1 + a.x * b.x + std::pow(a.x * b.x, 2) + a.q * b.q + a.x * a.q * b.x * b.q +
           std::pow(a.q * b.q, 2);
}

/// Product of the terms 1, x, q, u, v.
double wet_polynomial(const Coordinates& a, const Coordinates& b) {
    return 1 + a.x * b.x + a.q * b.q + a.u * b.u + a.v * b.v;
}

/// The covariance of values as the formula of `Kernel` states it. Where capillarity is linear in
/// 1/P*, every term of its polynomial has the factor u; contacts have the step to 1 instead.
double stated(Domain domain, const Hyperparameters& s, double coefficient_variance,
              const Coordinates& a, const Coordinates& b) {
    if (domain == Domain::bridges) {
        return coefficient_variance * wet_polynomial(a, b) + wet_process(s, a, b);
    }
    const double both = domain == Domain::all_flow ? a.u * b.u : a.u > 0 && b.u > 0;
    return coefficient_variance * (dry_polynomial(a, b) + both * wet_polynomial(a, b)) +
           dry_process(s, a, b) + both * wet_process(s, a, b);
}

class EachKernel : public testing::TestWithParam<Domain> {
  protected:
    /// Coefficients of the polynomial are about 5 units: variance 1.
    const Kernel kernel{GetParam(), uneven_hyperparameters(), 0.2};
};

INSTANTIATE_TEST_SUITE_P(Kernel, EachKernel,
                         testing::Values(Domain::all_flow, Domain::contacts, Domain::bridges),
                         [](const auto& each) { return name_of(each.param); });

TEST_P(EachKernel, IsTheStatedCovariance) {
    // The same sum in another order: 20 terms of size 1, rounded at 1e-16.
    const Kernel larger(GetParam(), uneven_hyperparameters(), 3);
    EXPECT_DOUBLE_EQ(larger.coefficient_variance(), 225);
    std::vector<Coordinates> places = scattered_places(6, 1);
    places.push_back(one_place);
    places.push_back(other_place);
    places.push_back({.x = 0.1, .q = 0.2, .u = 0, .v = 0});
    for (const Coordinates& a : places) {
        for (const Coordinates& b : places) {
            const double expected = stated(GetParam(), uneven_hyperparameters(), 225, a, b);
            EXPECT_NEAR(larger(larger.prepare(Functional{a}), larger.prepare(Functional{b})),
                        expected, 1e-13 * (1 + std::abs(expected)));
        }
    }
}

TEST_P(EachKernel, IsSymmetric) {
    const auto functionals = prepared_with_derivatives(kernel, scattered_places(8, 2));
    for (const auto& a : functionals) {
        for (const auto& b : functionals) {
            EXPECT_NEAR(kernel(a, b), kernel(b, a), 1e-14 * (1 + std::abs(kernel(a, b))));
        }
    }
}

TEST_P(EachKernel, DifferentiatesItsCovariance) {
    // Central differences of step h are off by h^2/6 times the third derivative, of order
    // 1/length^3 = 64 and for u near 0.1 some 1000: 2e-8; rounding makes 1e-16/h = 1e-11.
    constexpr double step = 1e-5, tolerance = 1e-7;
    for (const Coordinates& a : scattered_places(5, 3)) {
        for (const auto& b : prepared_with_derivatives(kernel, scattered_places(4, 4))) {
            for (int by = 0; by < coordinate_count; ++by) {
                const auto at = [&](double off) {
                    return kernel(kernel.prepare(Functional{moved(a, by, off)}), b);
                };
                EXPECT_NEAR(kernel(kernel.prepare(Functional{a, by}), b),
                            (at(step) - at(-step)) / (2 * step), tolerance)
                    << by << ", " << b.derivative;
            }
        }
    }
}

TEST_P(EachKernel, MakesPositiveSemidefiniteMatrices) {
    // Rounding of a matrix of 200 rows makes eigenvalues of at most 200 x 2e-16 of the largest.
    std::vector<Coordinates> places = scattered_places(36, 5);
    for (const double x : {-1.0, 0.0, 0.0, 1.0}) {
        places.push_back({.x = x, .q = 0, .u = 0, .v = 0});  // two of them the same
    }
    const Eigen::MatrixXd matrix = kernel.matrix(prepared_with_derivatives(kernel, places));
    EXPECT_EQ(matrix, matrix.transpose());
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
            .eigenvalues();
    EXPECT_GE(values.minCoeff(), -1e-13 * values.maxCoeff());
}

TEST_P(EachKernel, SumsWhatItWouldSumOneByOne) {
    const auto known = kernel.prepare(scattered_places(20, 6));
    const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(20, -1, 2);
    const auto summed = kernel.known(known, weights);
    std::vector<Coordinates> places = scattered_places(4, 7);
    places.push_back({.x = 0.3, .q = 0, .u = 0, .v = 0});
    for (const Coordinates& at : places) {
        const auto sums = kernel.sums(summed, kernel.prepare(Functional{at}), true);
        EXPECT_EQ(kernel.sums(summed, kernel.prepare(Functional{at}), false)[0], sums[0]);
        for (int derivative = Functional::value; derivative < coordinate_count; ++derivative) {
            double expected = 0;
            for (std::size_t i = 0; i < known.size(); ++i) {
                expected +=
                    weights(static_cast<Eigen::Index>(i)) *
                    kernel.of_processes(known[i], kernel.prepare(Functional{at, derivative}));
            }
            EXPECT_NEAR(sums[static_cast<std::size_t>(1 + derivative)], expected,
                        1e-13 * (1 + std::abs(expected)))
                << derivative;
        }
    }
}

TEST_P(EachKernel, DifferentiatesTracesByItsScales) {
    // tr(W K)/2 with K of some hyperparameters by central differences in their logarithms: off by
    // h^2/6 times the third derivative, of the order of the trace itself.
    constexpr double step = 1e-4;
    const auto places = scattered_places(10, 8);
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(10, 10);
    for (Eigen::Index i = 0; i < 10; ++i) {
        for (Eigen::Index j = 0; j < 10; ++j) {
            weights(i, j) = std::cos(static_cast<double>(i + j)) + (i == j ? 1 : 0);
        }
    }
    const auto half_trace = [&](std::size_t which, double off) {
        auto hyperparameters = uneven_hyperparameters().as_array();
        hyperparameters[which] *= std::exp(off);
        // A unit of 0 leaves out the polynomial, which does not depend on the hyperparameters.
        const Kernel changed(GetParam(), Hyperparameters::from_array(hyperparameters), 0);
        return 0.5 * (weights * changed.matrix(changed.prepare(places))).trace();
    };
    const auto traces = kernel.half_traces(kernel.prepare(places), weights);
    for (std::size_t k = 0; k < traces.size(); ++k) {
        EXPECT_NEAR(traces[k], (half_trace(k, step) - half_trace(k, -step)) / (2 * step), 1e-7)
            << Hyperparameters::names[k];
    }
}

TEST_P(EachKernel, IsFiniteInTheQuasiStaticLimit) {
    // q = I^(1/2) is 0 at I = 0, and 1e-9 there changes a covariance by 1e-9 times its slope in q,
    // which is below 100 here.
    const FlowState wet{.friction = 0.3, .inverse_pressure = 0.4, .bridge_volume = 0.001};
    const Coordinates at = coordinates(wet, 0.2, 0.5);
    EXPECT_EQ(at.q, 0);
    for (const auto& b : prepared_with_derivatives(kernel, {at, one_place})) {
        for (int derivative = Functional::value; derivative < coordinate_count; ++derivative) {
            const double limit = kernel(kernel.prepare(Functional{at, derivative}), b);
            EXPECT_TRUE(std::isfinite(limit));
            EXPECT_NEAR(kernel(kernel.prepare(Functional{moved(at, 1, 1e-9), derivative}), b),
                        limit, 1e-7);
        }
    }
}

TEST(Kernel, HasTheStatedVarianceOfItsSlopes) {
    // At one place the exponents vanish, and so do products of a value with a slope of g. What is
    // left of d/da d/db A^2 exp(-(a - b)^2/(2 l^2)) is A^2/l^2. For u the wet process is
    // u B g(s), s = ln(1 + u/0.1), ds/du = 1/(0.1 + u): variance B^2 (1 + (u ds/du)^2/l^2).
    const Hyperparameters s = uneven_hyperparameters();
    const Kernel kernel(Domain::all_flow, s, 0);  // no polynomial
    const double a2 = s.dry_amplitude * s.dry_amplitude, b2 = s.wet_amplitude * s.wet_amplitude;
    const double u = one_place.u, u2 = u * u;
    const double ds = 1 / (0.1 + u);
    const std::array<double, coordinate_count> expected = {
        a2 / (s.dry_x * s.dry_x) + u2 * b2 / (s.wet_x * s.wet_x),
        a2 / (s.dry_q * s.dry_q) + u2 * b2 / (s.wet_q * s.wet_q),
        b2 * (1 + u2 * ds * ds / (s.wet_u * s.wet_u)), u2 * b2 / (s.wet_v * s.wet_v)};
    for (int by = 0; by < coordinate_count; ++by) {
        const auto slope = kernel.prepare(Functional{one_place, by});
        EXPECT_NEAR(kernel(slope, slope), expected[static_cast<std::size_t>(by)], 1e-14) << by;
        // A value and a slope covary as half the slope of the variance, A^2 + u^2 B^2.
        EXPECT_NEAR(kernel(kernel.prepare(Functional{one_place}), slope), by == 2 ? u * b2 : 0.0,
                    1e-14);
    }
}

TEST(Kernel, HasTheStatedSlopesAlongFriction) {
    // With d = xa - xb: dk/dxa = -d/l^2 k, dk/dxb = d/l^2 k, d2k/dxa dxb = (1/l^2 - d^2/l^4) k.
    const Hyperparameters s = uneven_hyperparameters();
    const Kernel kernel(Domain::all_flow, s, 0);
    const Coordinates a{.x = 0.9, .q = 0.1}, b{.x = 0.2, .q = 0.3};  // dry
    const double k = dry_process(s, a, b), l2 = s.dry_x * s.dry_x, d = a.x - b.x;
    EXPECT_NEAR(kernel(kernel.prepare(Functional{a, 0}), kernel.prepare(Functional{b})),
                -d / l2 * k, 1e-15);
    EXPECT_NEAR(kernel(kernel.prepare(Functional{a}), kernel.prepare(Functional{b, 0})), d / l2 * k,
                1e-15);
    EXPECT_NEAR(kernel(kernel.prepare(Functional{a, 0}), kernel.prepare(Functional{b, 0})),
                (1 / l2 - d * d / (l2 * l2)) * k, 1e-15);
}

TEST(Kernel, KnowsNoLiquidInDryFlow) {
    Hyperparameters wetter = uneven_hyperparameters();
    wetter.wet_amplitude *= 10;
    wetter.wet_x /= 3;
    Coordinates dry = one_place;
    dry.u = 0;
    for (const Domain domain : {Domain::all_flow, Domain::contacts}) {
        const Kernel kernel(domain, uneven_hyperparameters(), 0.2), other(domain, wetter, 0.2);
        for (const Coordinates& b : {dry, other_place}) {
            const double expected =
                kernel(kernel.prepare(Functional{dry}), kernel.prepare(Functional{b}));
            EXPECT_EQ(
                kernel(kernel.prepare(Functional{moved(dry, 3, 2)}), kernel.prepare(Functional{b})),
                expected);
            EXPECT_EQ(other(other.prepare(Functional{dry}), other.prepare(Functional{b})),
                      expected);
            EXPECT_EQ(kernel(kernel.prepare(Functional{dry, 3}), kernel.prepare(Functional{b})), 0);
        }
    }
}

TEST(Kernel, LetsCapillarityVanishWithTheReciprocalPressure) {
    // The variance of what the liquid adds to a value is u^2 [B^2 + c (1 + x^2 + q^2 + u^2 + v^2)].
    // Contacts keep it without the factor u^2 until the flow is dry.
    const Hyperparameters s = uneven_hyperparameters();
    const double b2 = s.wet_amplitude * s.wet_amplitude;
    Coordinates dry = one_place;
    dry.u = 0;
    const auto added = [&](Domain domain, double u) {
        const Kernel kernel(domain, s, 0.2);
        const auto at = kernel.prepare(Functional{moved(dry, 2, u)}),
                   without = kernel.prepare(Functional{dry});
        return kernel(at, at) - kernel(without, without);
    };
    for (const double u : {0.0, 1e-6, 1e-3, 0.1}) {
        const double per_square = b2 + wet_polynomial(moved(dry, 2, u), moved(dry, 2, u));
        EXPECT_NEAR(added(Domain::all_flow, u), u * u * per_square, 1e-15);
        EXPECT_NEAR(added(Domain::contacts, u), u > 0 ? per_square : 0.0, 1e-15);
    }
}

TEST(Hyperparameters, AreReadBackFromTheirArray) {
    // In the order of their names.
    const std::array<double, Hyperparameters::count> numbers = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    const Hyperparameters hyperparameters = Hyperparameters::from_array(numbers);
    EXPECT_EQ(hyperparameters.as_array(), numbers);
    EXPECT_EQ(hyperparameters.dry_q, 3);
    EXPECT_EQ(hyperparameters.wet_v, 8);
    EXPECT_EQ(hyperparameters.between_run_scatter, 10);
}

}  // namespace pendular::calib_kernel_test
