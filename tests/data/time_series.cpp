#include "data/recordings/time_series.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include "data/recordings/autoregression.h"
#include "tests/support/data_support.h"

namespace pendular::data_time_series_test {

constexpr int series_count = 3000;

struct Correlated {
    std::size_t n;
    double rho;
};

void PrintTo(const Correlated& c, std::ostream* out) {
    *out << "n" << c.n << " rho" << c.rho;
}

class StandardError : public testing::TestWithParam<Correlated> {};

// The squared standardised error of a mean known exactly averages 1, with a standard deviation of
// sqrt(2/3000) = 0.026 over 3000 series were the error exact. It is estimated too, so the limits
// are those of an honest error rather than of chance: 20 % on the variance is 10 % on the error,
// and 7 of the 0.026. Measured: 0.88 to 1.02, and 1.10 for n = 100, rho = 0.9, where only five
// samples are independent. There Wolff's window alone gives 2.06: errors 30 % too small.
TEST_P(StandardError, IsHonestForShortCorrelatedSeries) {
    std::mt19937_64 random(7);
    double squares = 0;
    for (int i = 0; i < series_count; ++i) {
        const Mean mean = mean_of_correlated(autoregressive(GetParam().n, GetParam().rho, random));
        squares += std::pow(mean.value / mean.standard_error, 2);
    }
    EXPECT_NEAR(squares / series_count, 1, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Autoregressive, StandardError,
                         testing::Values(Correlated{100, 0}, Correlated{100, 0.5},
                                         Correlated{100, 0.9}, Correlated{300, 0},
                                         Correlated{300, 0.5}, Correlated{300, 0.9},
                                         Correlated{300, -0.5}));

TEST(MeanOfCorrelated, FindsTheAutocorrelationTime) {
    // 2 tau = (1 + rho)/(1 - rho) = 9 at rho = 0.8; with n = 2000, 2 tau is known to
    // sqrt(4 W/n) = 25 % at most, and averaged over 50 series to 4 %. Five of these: 0.2.
    std::mt19937_64 random(1);
    double sum = 0;
    for (int i = 0; i < 50; ++i)
        sum += mean_of_correlated(autoregressive(2000, 0.8, random)).correlation_samples;
    EXPECT_NEAR(sum / 50, 9, 0.2 * 9);
}

TEST(MeanOfCorrelated, IsExactForAHandComputedSeries) {
    const std::vector<double> samples = {1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(mean_of_correlated(samples).value, 2.5);
}

TEST(MeanOfCorrelated, ScalesWithTheUnit) {
    std::mt19937_64 random(3);
    std::vector<double> series = autoregressive(200, 0.7, random);
    const Mean plain = mean_of_correlated(series);
    for (double& sample : series)
        sample = 1000 * sample + 5e4;
    const Mean scaled = mean_of_correlated(series);
    EXPECT_NEAR(scaled.standard_error, 1000 * plain.standard_error, 1e-6);
    EXPECT_NEAR(scaled.correlation_samples, plain.correlation_samples, 1e-6);
}

TEST(MeanOfCorrelated, HandlesWhatHasNoScatter) {
    const Mean mean = mean_of_correlated(std::vector<double>(50, 0.1));
    EXPECT_DOUBLE_EQ(mean.value, 0.1);
    EXPECT_EQ(mean.standard_error, 0);
}

/// The sum of many equal samples has a rounding error, so that no sample equals the mean. Taken for
/// scatter, it would be correlated over the whole series.
TEST(MeanOfCorrelated, SeesNoScatterInManyEqualSamples) {
    const Mean mean = mean_of_correlated(std::vector<double>(200'000, 0.1));
    EXPECT_EQ(mean.standard_error, 0);
    EXPECT_EQ(mean.correlation_samples, 1);
}

TEST(MeanOfCorrelated, KnowsNothingFromOneSample) {
    EXPECT_TRUE(std::isinf(mean_of_correlated(std::vector<double>{3}).standard_error));
    EXPECT_THROW(mean_of_correlated({}), std::invalid_argument);
}

TEST(MeanOfCorrelated, IsFiniteAndPositiveForAnyShortSeries) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> rho(-0.95, 0.95);
    for (std::size_t n = 2; n < 60; ++n) {
        const double error =
            mean_of_correlated(autoregressive(n, rho(random), random)).standard_error;
        EXPECT_TRUE(std::isfinite(error) && error > 0) << n;
    }
}

TEST(CovarianceOfMeans, MakesTheErrorOfADifferenceHonest) {
    // y = 0.6 x + 0.8 x', x and x' independent: correlation 0.6. The variance of mean(x) - mean(y)
    // then is 0.8 of the single ones, against 2 without the covariance. Limits as above.
    for (const double rho : {0.0, 0.5, 0.8}) {
        std::mt19937_64 random(5);
        double squares = 0, correlation = 0;
        for (int i = 0; i < series_count; ++i) {
            const std::vector<double> x = autoregressive(300, rho, random);
            std::vector<double> y = autoregressive(300, rho, random);
            for (std::size_t t = 0; t < y.size(); ++t)
                y[t] = 0.6 * x[t] + 0.8 * y[t];
            const Mean mx = mean_of_correlated(x), my = mean_of_correlated(y);
            const double shared = covariance_of_means(x, y);
            correlation += shared / (mx.standard_error * my.standard_error);
            squares +=
                std::pow(mx.value - my.value, 2) /
                (std::pow(mx.standard_error, 2) + std::pow(my.standard_error, 2) - 2 * shared);
        }
        EXPECT_NEAR(squares / series_count, 1, 0.2) << rho;
        EXPECT_NEAR(correlation / series_count, 0.6, 0.03) << rho;
    }
}

TEST(CovarianceOfMeans, StaysInvertibleForIdenticalSeries) {
    std::mt19937_64 random(5);
    const std::vector<double> x = autoregressive(100, 0.5, random);
    const double variance = std::pow(mean_of_correlated(x).standard_error, 2);
    EXPECT_NEAR(covariance_of_means(x, x), 0.99 * variance, 1e-12);
    EXPECT_EQ(covariance_of_means(x, std::vector<double>(100, 1.0)), 0);
}

TEST(EndOfTransient, FindsWhereASeriesSettles) {
    // A transient 10 exp(-t/20) on noise of 1 is lost in it after 20 ln 10 = 46 samples.
    std::mt19937_64 random(2);
    for (int i = 0; i < 100; ++i) {
        std::vector<double> series = autoregressive(400, 0.3, random);
        for (std::size_t t = 0; t < series.size(); ++t)
            series[t] += 10 * std::exp(-static_cast<double>(t) / 20);
        const auto end = end_of_transient(series);
        ASSERT_TRUE(end.has_value());
        EXPECT_GE(*end, 20u);
        EXPECT_LE(*end, 200u);
    }
}

TEST(EndOfTransient, KeepsNearlyAllOfASteadySeries) {
    // Measured over 3000 series of n = 300: cut 2 % on average, 0.1 % found unsteady.
    std::mt19937_64 random(4);
    std::size_t cut = 0;
    for (int i = 0; i < 200; ++i)
        cut += end_of_transient(autoregressive(300, 0, random)).value();
    EXPECT_LT(static_cast<double>(cut) / 200, 0.05 * 300);
}

TEST(EndOfTransient, SeldomRefusesShortSteadySeries) {
    // White noise, n = 50: measured 0.1 % over 3000 (with batches of five, 10 %). Five in 500 is
    // exceeded with a probability below 1e-4 at that rate.
    std::mt19937_64 random(6);
    int refused = 0;
    for (int i = 0; i < 500; ++i)
        refused += !end_of_transient(autoregressive(50, 0, random));
    EXPECT_LE(refused, 5);
}

TEST(EndOfTransient, RefusesADrift) {
    std::mt19937_64 random(8);
    for (int i = 0; i < 50; ++i) {
        std::vector<double> series = autoregressive(200, 0, random);
        for (std::size_t t = 0; t < series.size(); ++t)
            series[t] += 0.1 * static_cast<double>(t);
        EXPECT_EQ(end_of_transient(series), std::nullopt);
    }
}

/// The definition, batch by batch: the d that minimises sum_{i>=d} (x_i - mean_d)^2/(n - d)^2.
TEST(EndOfTransient, IsTheMinimumOfTheMarginalError) {
    std::mt19937_64 random(9);
    for (int i = 0; i < 20; ++i) {
        std::vector<double> series = autoregressive(40, 0, random);
        for (std::size_t t = 0; t < series.size(); ++t)
            series[t] += 8 * std::exp(-static_cast<double>(t) / 3);
        std::size_t best = 0;
        double lowest = INFINITY;
        for (std::size_t d = 0; d <= series.size() / 2; ++d) {
            double mean = 0, squares = 0;
            const double left = static_cast<double>(series.size() - d);
            for (std::size_t t = d; t < series.size(); ++t)
                mean += series[t] / left;
            for (std::size_t t = d; t < series.size(); ++t)
                squares += (series[t] - mean) * (series[t] - mean);
            if (squares / (left * left) < lowest) lowest = squares / (left * left), best = d;
        }
        const auto found = end_of_transient(series);
        if (found) {
            EXPECT_EQ(*found, best);
        }
    }
}

TEST(EndOfTransient, TakesAConstantForSteadyAndTooFewSamplesForNothing) {
    EXPECT_EQ(end_of_transient(std::vector<double>(100, 0.1)), 0u);
    EXPECT_EQ(end_of_transient(std::vector<double>(3, 0.1)), std::nullopt);
}

TEST(LaggedCovariances, AreTheSameOneByOneAndAllAtOnce) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    const std::size_t n = 3000;
    std::vector<double> first(n), second(n);
    for (std::size_t i = 0; i < n; ++i) {
        first[i] = 5 + normal(random) + (i > 0 ? 0.9 * (first[i - 1] - 5) : 0);
        second[i] = first[i] + normal(random);
    }
    LaggedCovariances alone(first, second), at_once(first, second);
    at_once(n - 1);
    for (std::size_t lag = 0; lag < LaggedCovariances::first_lag_by_fourier_transform; ++lag)
        EXPECT_NEAR(at_once(lag), alone(lag), 1e-11);
    double by_hand = 0, mean1 = plain_mean(first), mean2 = plain_mean(second);
    for (std::size_t i = 0; i + 1000 < n; ++i)
        by_hand += (first[i] - mean1) * (second[i + 1000] - mean2) +
                   (first[i + 1000] - mean1) * (second[i] - mean2);
    EXPECT_NEAR(at_once(1000), by_hand / 2 / static_cast<double>(n - 1000), 1e-11);
}

}  // namespace pendular::data_time_series_test
