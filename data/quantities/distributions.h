#pragma once

namespace pendular {

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
