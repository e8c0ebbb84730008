#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pendular {

/// Returns the arithmetic mean of values, in the unit of the values; NaN for an empty list.
double plain_mean(std::span<const double> samples);

/// Lagged covariances C(t) of two series, in the product of the units of the series. C(t) is the
/// mean of two covariances: the first series with the second series t values later, and the second
/// series with the first series t values later.
class LaggedCovariances {
  public:
    /// Prepares the covariances of two series. For the autocovariances of one series, pass the
    /// series twice.
    /// @param first,second series of equal length, recorded at equal times
    LaggedCovariances(std::span<const double> first, std::span<const double> second);

    /// Smallest lag, as a number of values, from which on all covariances are computed together by
    /// Fourier transforms. The covariances at smaller lags are computed one by one.
    static constexpr std::size_t first_lag_by_fourier_transform = 512;

    /// Returns the covariance C(lag) of the two series, in the product of the units of the series.
    /// @param lag number of values by which one series is shifted, less than the length of the
    ///         series
    double operator()(std::size_t lag);
    /// Returns the sum of the covariances C(t) of the two series over all lags t from -window to
    /// window, in the product of the units of the series:
    ///     C(0) + 2 sum_{t=1}^{window} C(t)
    /// @param window largest lag as a number of values, less than the length of the series
    double summed(std::size_t window);

  private:
    double at(std::size_t lag) const;
    std::vector<double> all() const;

    std::vector<double> first_, second_, known_;
};

/// Autoregressive model of the noise of a series. The deviation x_t of each value from the mean is
/// a sum of earlier deviations, with the coefficients a_1, a_2, ..., and of an independent random
/// number, the innovation.
///     x_t = sum_j a_j x_(t-j) + innovation
struct Autoregression {
    /// Coefficients a_1, a_2, ... of the autoregressive model [1]. The coefficient a_j multiplies
    /// the deviation from the mean that the series has j values earlier.
    std::vector<double> coefficients = {};
    /// Variance of the innovation (random part of a value) in the autoregressive model, in the
    /// squared unit of the series.
    double innovation = 0;

    /// Returns the order of the autoregressive model, which is the number of coefficients.
    double order() const { return static_cast<double>(coefficients.size()); }
    /// Returns the spectral density of the series at frequency zero, in the squared unit of the
    /// series. Divided by the number `count` of values in the series, the spectral density is the
    /// variance of the mean of the series.
    ///     innovation count/(count - 1 - order)/(1 - b)^2
    ///     b = min(a + (1 + 3 a)/count, 1 - 2/count)      a: sum of the coefficients
    /// The number b is the estimated sum a, corrected for its bias -(1 + 3 a)/count. Without
    /// coefficients, b = 0. The factor count/(count - 1 - order) allows for the degrees of freedom
    /// of the estimated mean and coefficients.
    /// Source: Marriott and Pope (1954), for order 1.
    double spectrum_at_zero(double count) const;
    /// Returns the spectral density of the series at a frequency in cycles per value, in the
    /// squared unit of the series. For independent values, the spectral density equals the variance
    /// of the values.
    ///     (variance of the innovation)/|1 - sum_j a_j exp(-2 pi i j frequency)|^2
    /// The numbers a_j are the coefficients of the model.
    double spectrum(double frequency) const;
};

/// Returns the autoregressive model of a series of n values. The Bayesian information criterion
/// chooses the order of the model, which is at most 10 and at most n/10. The variance of the
/// innovation (random part of a value) is 0 if the series is constant.
/// @param covariance lagged covariances of the series with itself
Autoregression best_autoregression(LaggedCovariances& covariance, std::size_t n);

/// Returns the autoregressive model of a series by Burg's method, whose order, at most `highest`,
/// the Bayesian information criterion chooses. Unlike `best_autoregression`, it follows steep
/// spectra, as those behind low-pass filters, since it takes no values beyond the ends of the
/// series for 0.
/// @param samples deviations from the mean
/// Source: Burg (1975), Maximum entropy spectral analysis, thesis, Stanford.
Autoregression burg_autoregression(std::span<const double> samples, std::size_t highest);

}  // namespace pendular
