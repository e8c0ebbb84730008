#pragma once

#include <span>
#include <vector>

namespace pendular {

/// Returns the median, in the unit of the values; 0 if there are none.
double median(std::vector<double> values);

/// Returns a robust standard deviation, in the unit of the values: 1.4826 times the median absolute
/// deviation from the median, which for normal values is the standard deviation.
double robust_deviation(std::span<const double> values);

/// Returns the standard deviation of the noise of a series, in its unit: `robust_deviation` of the
/// differences between neighbouring values over sqrt(2), to which slow changes hardly contribute.
double sample_noise(std::span<const double> series);

/// Returns the resolution of values, in their unit: the smallest difference between distinct
/// values; 0 if all are equal. Differences below 1e-9 of the largest value are rounding errors.
double least_step(std::vector<double> values);

// Distributions of the statistics that tests use. Boost.Math computes them; its templates take
// seconds to compile in each file that sees them, so that one file does. `freedom`: degrees of
// freedom [1], not necessarily whole. A tail is the probability [1] of a larger value.

double normal_below(double z);  ///< probability of a smaller value [1]
double normal_density(double z);
double normal_quantile(double probability);

double students_t_tail(double t, double freedom);
double students_t_quantile(double probability, double freedom);

double chi_squared_tail(double value, double freedom);
double chi_squared_quantile(double probability, double freedom);
/// Value with this tail; exact also for tails near 0, which 1 minus a probability cannot hold.
double chi_squared_exceeded_by(double tail, double freedom);
/// @param away sum of squared means of the normal variables, the non-centrality [1]
double non_central_chi_squared_tail(double value, double freedom, double away);

double fisher_f_tail(double ratio, double freedom_above, double freedom_below);
double fisher_f_quantile(double probability, double freedom_above, double freedom_below);

/// Probability of at least `successes` (at least 1) in `trials` with this probability each [1].
double binomial_at_least(double successes, double trials, double probability);

double digamma(double x);
double trigamma(double x);

}  // namespace pendular
