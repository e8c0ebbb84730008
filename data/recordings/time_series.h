#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pendular {

/// Mean of correlated values, with its standard error, in their unit.
struct Mean {
    double value = 0;
    double standard_error = 0;  ///< autocorrelation included
    /// Integrated autocorrelation time 2 tau as a number of values; 1 for independent values.
    double correlation_samples = 1;
};

/// Returns the mean and the standard error se of n evenly spaced, correlated values, in their unit.
///     se^2 = (2 tau) C(0)/n (1 + 2/(nu - 1)),   2 tau = 1 + 2 sum_{t=1}^{W} C(t)/C(0)
/// C(t) is the autocovariance at lag t, corrected for the bias of the estimated mean, and
/// nu = n/(2 tau). Wolff's method with S = 1.5 chooses the window W. The best autoregressive model
/// gives a lower limit of 2 tau. The standard error is right within 10 % if nu >= 5, infinite for
/// one value, and 0 for constant values.
/// @throws std::invalid_argument if there are no values
/// Source: Wolff, Comput. Phys. Commun. 156 (2004) 143, "Monte Carlo errors with less errors".
Mean mean_of_correlated(std::span<const double> samples);

/// Returns values without the slope of the best straight line, in their unit; the mean is kept.
std::vector<double> without_line(std::span<const double> samples);

/// Returns the covariance of the means of two series recorded at equal times, in the product of
/// their units. Cross-covariances are summed up to the larger of the windows that
/// `mean_of_correlated` uses for the two; the correlation is limited to [-0.99, 0.99].
/// @throws std::invalid_argument if the series differ in length or are empty
double covariance_of_means(std::span<const double> first, std::span<const double> second);

/// Returns the number d of values in the transient of a series of n, which minimises, up to n/2,
/// the squared standard error of the mean of the others:
///     s^2(d)/(n - d)      s^2(d): variance of the last n - d values
/// Empty if the series does not become steady: d = n/2, or the two halves of the last n - d values
/// differ by more than 4 standard errors. At most 1 % of steady series give an empty result, if
/// 2 tau <= 3 and n >= 50.
/// Source: White, Simulation 69 (1997) 323 (MSER-5).
std::optional<std::size_t> end_of_transient(std::span<const double> samples);

}  // namespace pendular
