#include "data/recordings/time_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "data/recordings/autoregression.h"

namespace pendular {
namespace {

/// Integrated autocorrelation time with the window that it was summed over.
struct Correlation {
    double samples = 1;      ///< 2 tau, in samples
    std::size_t window = 0;  ///< largest lag W, in samples
};

/// Integrated autocorrelation time 2 tau of n samples by Wolff's Gamma method. The window is the
/// smallest W with
///     exp(-W/tau) < tau/sqrt(W n),   tau = S / ln((2 tau_int + 1)/(2 tau_int - 1)),   S = 1.5.
/// Two corrections for the bias of the estimated mean follow, eqs. (32) and (49).
/// Source: Wolff, Comput. Phys. Commun. 156 (2004) 143.
Correlation windowed_correlation(LaggedCovariances& covariance, std::size_t n) {
    constexpr double s = 1.5;  // as Wolff proposes
    const double count = static_cast<double>(n);
    double tau_int = 0.5;
    std::size_t window = 0;
    while (window < n / 2) {
        ++window;
        tau_int += covariance(window) / covariance(0);
        if (tau_int <= 0.5) break;  // no positive correlation
        const double tau = s / std::log((2 * tau_int + 1) / (2 * tau_int - 1));
        const double w = static_cast<double>(window);
        if (std::exp(-w / tau) < tau / std::sqrt(w * count)) break;
    }
    const double w = static_cast<double>(window);
    const double bias = covariance.summed(window) / count;
    const double unbiased = covariance.summed(window) + (2 * w + 1) * bias;
    const double two_tau = unbiased / (covariance(0) + bias) * (1 + (2 * w + 1) / count);
    return {two_tau, window};
}

/// Whether a variance about a mean is no more than rounding errors of the arithmetic.
bool constant(double variance, double mean) {
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * std::abs(mean);
    return variance <= rounding * rounding;
}

/// Whether all samples are equal but for rounding errors of the arithmetic. The variance about the
/// mean does not show it for many samples, since the mean of many samples has a rounding error.
bool all_equal(std::span<const double> samples) {
    const auto [least, most] = std::ranges::minmax(samples);
    const double range = most - least;
    return constant(range * range, most);
}

/// Whether the halves of a series differ by more than 4 standard errors. The errors are computed
/// from the scatter about the best line, since a drift would otherwise count as noise of long
/// correlation.
bool still_drifts(std::span<const double> samples) {
    const std::size_t half = samples.size() / 2;
    const double difference =
        std::abs(plain_mean(samples.first(half)) - plain_mean(samples.last(half)));
    if (constant(difference * difference, samples.front())) return false;
    // The mean of a half has twice the variance of the whole mean, the difference of two halves
    // four times.
    const double error = 2 * mean_of_correlated(without_line(samples)).standard_error;
    return difference > 4 * error;
}

}  // namespace

std::vector<double> without_line(std::span<const double> samples) {
    const double centre = static_cast<double>(samples.size() - 1) / 2;
    const double mean = plain_mean(samples);
    double products = 0, squares = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double t = static_cast<double>(i) - centre;
        products += t * (samples[i] - mean);
        squares += t * t;
    }
    std::vector<double> result(samples.begin(), samples.end());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] -= products / squares * (static_cast<double>(i) - centre);
    return result;
}

Mean mean_of_correlated(std::span<const double> samples) {
    if (samples.empty()) throw std::invalid_argument("the mean of no samples");
    const std::size_t n = samples.size();
    const double count = static_cast<double>(n);
    const double mean = plain_mean(samples);
    if (n == 1) return {mean, std::numeric_limits<double>::infinity(), 1};
    if (all_equal(samples)) return {mean, 0, 1};
    LaggedCovariances covariance(samples, samples);
    if (constant(covariance(0), mean)) return {mean, 0, 1};

    const double two_tau =
        std::max(windowed_correlation(covariance, n).samples,
                 best_autoregression(covariance, n).spectrum_at_zero(count) / covariance(0));
    // The error is an estimate from about n/(2 tau) independent samples. It is widened so that the
    // mean square of deviations over errors is 1, while it exceeds 1 for Student's t.
    const double independent = count / two_tau;
    const double widened = 1 + 2 / std::max(independent - 1, 1.0);
    return {mean, std::sqrt(two_tau * covariance(0) / count * widened), two_tau};
}

double covariance_of_means(std::span<const double> first, std::span<const double> second) {
    if (first.size() != second.size())
        throw std::invalid_argument("covariance of series of different length");
    const Mean a = mean_of_correlated(first);
    const Mean b = mean_of_correlated(second);
    if (first.size() < 2 || a.standard_error == 0 || b.standard_error == 0) return 0;

    LaggedCovariances own_first(first, first), own_second(second, second), cross(first, second);
    std::size_t window = std::max(windowed_correlation(own_first, first.size()).window,
                                  windowed_correlation(own_second, first.size()).window);
    double product = own_first.summed(window) * own_second.summed(window);
    if (own_first.summed(window) <= 0 || product <= 0) {  // anticorrelated: lag 0 alone
        window = 0;
        product = own_first(0) * own_second(0);
    }
    const double correlation = cross.summed(window) / std::sqrt(product);
    return std::clamp(correlation, -0.99, 0.99) * a.standard_error * b.standard_error;
}

namespace {

/// Number d <= `most` of leading values to leave out that gives the smallest squared marginal
/// standard error s^2(d)/(n - d) of the others. The mean and the sum of squares about it are
/// updated from the last value to the first (Welford 1962), so that the time is linear.
std::size_t least_marginal_error(std::span<const double> values, std::size_t most) {
    double mean = 0, squares = 0;
    double lowest = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t d = values.size(); d-- > 0;) {
        const double left = static_cast<double>(values.size() - d);
        const double change = values[d] - mean;
        mean += change / left;
        squares += change * (values[d] - mean);
        if (d > most) continue;
        const double marginal = constant(squares / left, mean) ? 0 : squares / (left * left);
        if (marginal > lowest) continue;
        lowest = marginal;
        best = d;
    }
    return best;
}

}  // namespace

std::optional<std::size_t> end_of_transient(std::span<const double> samples) {
    // Batches of five samples, fewer in short series: with fewer than about 40 batches the minimum
    // is too often at the border by chance.
    const std::size_t batch = std::clamp<std::size_t>(samples.size() / 40, 1, 5);
    std::vector<double> means;
    for (std::size_t i = 0; i + batch <= samples.size(); i += batch)
        means.push_back(plain_mean(samples.subspan(i, batch)));
    const std::size_t half = means.size() / 2;
    if (half < 2) return std::nullopt;

    const std::size_t best = least_marginal_error(means, half);
    if (best == half) return std::nullopt;

    if (still_drifts(samples.subspan(best * batch))) return std::nullopt;
    return best * batch;
}

}  // namespace pendular
