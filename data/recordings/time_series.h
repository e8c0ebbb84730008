#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

namespace pendular {

/// Mean of correlated samples with its standard error, both in the samples' unit.
struct Mean {
    double value = 0;
    double standard_error = 0;
    double correlation_samples =
        1;  ///< integrated autocorrelation time, in samples; 1: independent
};

/// Mean and standard error of evenly spaced, correlated samples, in their own unit.
///     se^2 = (2 tau) C(0)/n (1 + 2/(nu - 1)),   2 tau = 1 + 2 sum_{t=1}^{W} C(t)/C(0)
/// with the window W chosen automatically (S = 1.5) and the bias of C from the estimated mean
/// corrected; 2 tau is never below that of the best autoregression, and nu = n/(2 tau). Window
/// alone, errors of series of 100 samples with 2 tau = 19 are 30 % too small; so they are right
/// within 10 % from n/(2 tau) = 5 on.
/// One sample has an infinite standard error; samples without variance have none.
/// @throws std::invalid_argument for no samples
/// Source: Wolff, Comput. Phys. Commun. 156 (2004) 143, "Monte Carlo errors with less errors".
Mean mean_of_correlated(std::span<const double> samples);

/// Covariance of the means of two series of equal length sampled together, in the product of their
/// units: cross-correlations summed over the window of the slower of the two. The correlation
/// coefficient it implies is clamped to [-0.99, 0.99].
double covariance_of_means(std::span<const double> first, std::span<const double> second);

/// Number of leading samples to leave out as transient, found rather than assumed: the truncation
/// d that minimises the marginal standard error  s^2(d)/(n - d)  of the rest, over the first half
/// of the series after averaging in batches of five (of fewer below 200 samples). Empty where the
/// minimum is at the border of that half, or where the two halves of what remains differ by more
/// than 4 standard errors, taken about a line through it: the series is then not yet steady. Of
/// steady series with 2 tau <= 3, 1 % or less are refused from 50 samples on.
/// Source: White, Simulation 69 (1997) 323 (MSER-5).
std::optional<std::size_t> end_of_transient(std::span<const double> samples);

}  // namespace pendular
