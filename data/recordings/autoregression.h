#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pendular {

/// Arithmetic mean of samples, in the unit of the samples; NaN for an empty list.
double plain_mean(std::span<const double> samples);

/// Lagged covariances C(t) of two series of n samples, in the product of the units of the series.
/// C(t) is the covariance of one series with the other series t samples later, averaged over both
/// directions. A lag below `lags_alone` is computed when it is first requested; the first request
/// from `lags_alone` on computes all lags at once, by Fourier transforms.
class LaggedCovariances {
  public:
    /// Prepares the covariances of two series; for the autocovariances of one series, pass it
    /// twice.
    /// @param first,second series of equal length, sampled at the same times
    LaggedCovariances(std::span<const double> first, std::span<const double> second);

    /// Smallest lag, as a number of samples, whose first request causes the covariances at all lags
    /// to be computed at once, by Fourier transforms.
    static constexpr std::size_t lags_alone = 512;

    /// Covariance C(lag) of the two series, in the product of their units.
    /// @param lag number of samples, less than the length of the series
    double operator()(std::size_t lag);
    /// Sum of the covariances C(t) over all lags t from -window to window, in the product of the
    /// series' units:
    ///     C(0) + 2 sum_{t=1}^{window} C(t)
    /// @param window number of samples, less than the length of the series
    double summed(std::size_t window);

  private:
    double at(std::size_t lag) const;
    std::vector<double> all() const;

    std::vector<double> first_, second_, known_;
};

/// Autoregressive model of the noise of a series x_t: each sample is a sum of earlier samples, with
/// coefficients a_1, a_2, ..., and an independent random number, the innovation.
///     x_t = sum_j a_j x_(t-j) + innovation
struct Autoregression {
    /// Coefficients a_1, a_2, ... of the earlier samples in the autoregressive model [1].
    std::vector<double> coefficients = {};
    /// Variance of the innovation (random part of a sample) in the autoregressive model, in the
    /// squared unit of the series.
    double innovation = 0;

    /// Order of the autoregressive model: the number of its coefficients.
    double order() const { return static_cast<double>(coefficients.size()); }
    /// Spectral density of the series at frequency zero, in the squared unit of the series: `count`
    /// times the variance of the mean of `count` samples. The sum a of the coefficients is
    /// corrected for its bias, -(1 + 3 a)/count (Marriott and Pope 1954, for order 1), and kept
    /// below 1 - 2/count.
    double spectrum_at_zero(double count) const;
    /// Spectral density of the series at a frequency in cycles per sample, in the squared unit of
    /// the series; for independent samples, it equals their variance.
    ///     (variance of the innovation)/|1 - sum_j a_j exp(-2 pi i j frequency)|^2
    /// The numbers a_j are the coefficients of the model.
    double spectrum(double frequency) const;
};

/// Autoregressive model of a series of n samples, whose order is chosen by the Bayesian information
/// criterion. Its order is at most 10 and at most n/10. The variance of the innovation is 0 if the
/// series is constant.
/// @param covariance lagged covariances of the series with itself
Autoregression best_autoregression(LaggedCovariances& covariance, std::size_t n);

}  // namespace pendular
