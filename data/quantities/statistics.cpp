#include "data/quantities/statistics.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <numbers>

namespace pendular {

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

double robust_deviation(std::span<const double> values) {
    constexpr double normal = 1.4826;  // 1/(quantile of the normal distribution at 3/4)
    std::vector<double> distances(values.begin(), values.end());
    const double centre = median(distances);
    for (double& value : distances)
        value = std::abs(value - centre);
    return normal * median(std::move(distances));
}

double sample_noise(std::span<const double> series) {
    std::vector<double> differences;
    for (std::size_t i = 1; i < series.size(); ++i)
        differences.push_back(series[i] - series[i - 1]);
    return robust_deviation(differences) / std::numbers::sqrt2;
}

double least_step(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const double rounding = 1e-9 * std::max(std::abs(values.front()), std::abs(values.back()));
    double least = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double step = values[i] - values[i - 1];
        if (step > rounding && (least == 0 || step < least)) least = step;
    }
    return least;
}

namespace {

namespace math = boost::math;

template <class Law>
double tail_of(const Law& law, double value) {
    return math::cdf(math::complement(law, value));
}

}  // namespace

double normal_below(double z) {
    return math::cdf(math::normal(), z);
}

double normal_density(double z) {
    return math::pdf(math::normal(), z);
}

double normal_quantile(double probability) {
    return math::quantile(math::normal(), probability);
}

double students_t_tail(double t, double freedom) {
    return tail_of(math::students_t(freedom), t);
}

double students_t_quantile(double probability, double freedom) {
    return math::quantile(math::students_t(freedom), probability);
}

double chi_squared_tail(double value, double freedom) {
    return tail_of(math::chi_squared(freedom), value);
}

double chi_squared_quantile(double probability, double freedom) {
    return math::quantile(math::chi_squared(freedom), probability);
}

double chi_squared_exceeded_by(double tail, double freedom) {
    return math::quantile(math::complement(math::chi_squared(freedom), tail));
}

double non_central_chi_squared_tail(double value, double freedom, double away) {
    return tail_of(math::non_central_chi_squared(freedom, away), value);
}

double fisher_f_tail(double ratio, double freedom_above, double freedom_below) {
    return tail_of(math::fisher_f(freedom_above, freedom_below), ratio);
}

double fisher_f_quantile(double probability, double freedom_above, double freedom_below) {
    return math::quantile(math::fisher_f(freedom_above, freedom_below), probability);
}

double binomial_at_least(double successes, double trials, double probability) {
    return tail_of(math::binomial(trials, probability), successes - 1);
}

double digamma(double x) {
    return math::digamma(x);
}

double trigamma(double x) {
    return math::trigamma(x);
}

}  // namespace pendular
