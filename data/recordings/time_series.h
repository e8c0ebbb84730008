#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pendular {

/// Mean of correlated samples, with its standard error.
struct Mean {
    double value = 0;  ///< mean of the samples, in their unit
    /// Standard error of the mean, autocorrelation included, in the unit of the samples.
    double standard_error = 0;
    /// Integrated autocorrelation time 2 tau of the samples, as a number of samples; 1 for
    /// independent samples.
    double correlation_samples = 1;
};

/// Mean and standard error se of n evenly spaced, correlated samples, in the unit of the samples.
///     se^2 = (2 tau) C(0)/n (1 + 2/(nu - 1)),   2 tau = 1 + 2 sum_{t=1}^{W} C(t)/C(0)
/// C(t) is the autocovariance at lag t, corrected for the bias of the estimated mean; nu = n/(2
/// tau); the window W is chosen automatically (with Wolff's parameter S = 1.5). The autocorrelation
/// time 2 tau is at least that of the best autoregressive model: with the window alone, the errors
/// of 100 samples with 2 tau = 19 would be 30 % too small. Errors are right within 10 % if nu >= 5.
/// The standard error of one sample is infinite; the standard error of constant samples is 0.
/// @throws std::invalid_argument if there are no samples
/// Source: Wolff, Comput. Phys. Commun. 156 (2004) 143, "Monte Carlo errors with less errors".
Mean mean_of_correlated(std::span<const double> samples);

/// Returns samples without their trend, in the unit of the samples: the slope of the best straight
/// line is removed, and the mean is kept.
std::vector<double> without_line(std::span<const double> samples);

/// Covariance of the means of two series that were sampled together, in the product of their units.
/// The cross-covariances are summed over the larger of the two windows that `mean_of_correlated`
/// uses for the series. The correlation coefficient is limited to [-0.99, 0.99].
/// @throws std::invalid_argument if the series differ in length or are empty
double covariance_of_means(std::span<const double> first, std::span<const double> second);

/// Number of samples at the beginning of a series that belong to the transient; empty if the series
/// does not become steady.
///
/// The result is the number d in the first half of the n samples that minimises the squared
/// standard error s^2(d)/(n - d) of the n - d samples after it, with s^2(d) their variance, after
/// averaging in batches of five (fewer below 200 samples). The series is not steady if the minimum
/// is at the end of the first half, or if the two halves of the remaining samples differ by more
/// than 4 standard errors (computed about the best line, so that a drift does not count as
/// scatter). At most 1 % of steady series with an autocorrelation time 2 tau <= 3 samples and at
/// least 50 samples are found not to be steady.
/// Source: White, Simulation 69 (1997) 323 (MSER-5).
std::optional<std::size_t> end_of_transient(std::span<const double> samples);

}  // namespace pendular
