#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pendular {

/// Returns the mean without weights, in the unit of the values; NaN for an empty list.
double plain_mean(std::span<const double> samples);

/// Lagged covariances C(t) of two series, in the product of their units: mean of the covariance
/// with the second series t values later and of that with the first series t values later. For
/// autocovariances, the two series are the same.
class LaggedCovariances {
  public:
    /// @param first,second series of equal length, recorded at equal times
    LaggedCovariances(std::span<const double> first, std::span<const double> second);

    /// Lag, in values, from which on all covariances are computed together by Fourier transforms.
    /// Chosen: most series need fewer lags, each of which alone is quickly computed.
    static constexpr std::size_t first_lag_by_fourier_transform = 512;

    /// Returns C(lag), for a lag below the length of the series.
    double operator()(std::size_t lag);
    /// Returns C(0) + 2 sum_{t=1}^{window} C(t), for a window below the length of the series.
    double summed(std::size_t window);

  private:
    double at(std::size_t lag) const;
    std::vector<double> all() const;

    std::vector<double> first_, second_, known_;
};

/// Autoregressive model of the noise of a series: the deviation x_t of a value from the mean is a
/// sum of earlier deviations and of an independent random number, the innovation.
///     x_t = sum_j a_j x_(t-j) + innovation
struct Autoregression {
    std::vector<double> coefficients = {};  ///< a_1, a_2, ... [1]
    double innovation = 0;                  ///< variance of the innovation [squared unit]

    double order() const { return static_cast<double>(coefficients.size()); }
    /// Returns the spectral density at frequency zero, in the squared unit of the series; divided
    /// by the number `count` of values, it is the variance of the mean of the series.
    ///     innovation count/(count - 1 - order)/(1 - b)^2
    ///     b = min(a + (1 + 3 a)/count, 1 - 2/count)      a: sum of the coefficients
    /// b is a, corrected for its bias -(1 + 3 a)/count, or 0 without coefficients. The factor
    /// count/(count - 1 - order) allows for the estimated mean and coefficients.
    /// Source: Marriott and Pope (1954), for order 1.
    double spectrum_at_zero(double count) const;
    /// Returns the spectral density at a frequency in cycles per value, in the squared unit of the
    /// series. For independent values, it equals their variance.
    ///     innovation/|1 - sum_j a_j exp(-2 pi i j frequency)|^2
    double spectrum(double frequency) const;
};

/// Returns the autoregressive model of a series of n values, of the order, at most 10 and n/10,
/// that the Bayesian information criterion chooses. The innovation of a constant series is 0.
/// @param covariance lagged covariances of the series with itself
Autoregression best_autoregression(LaggedCovariances& covariance, std::size_t n);

/// Returns the autoregressive model by Burg's method, of the order, at most `highest`, that the
/// Bayesian information criterion chooses. Unlike `best_autoregression`, it follows steep spectra,
/// as those behind low-pass filters, since it takes no values beyond the ends of the series for 0.
/// @param samples deviations from the mean
/// Source: Burg (1975), Maximum entropy spectral analysis, thesis, Stanford.
Autoregression burg_autoregression(std::span<const double> samples, std::size_t highest);

}  // namespace pendular
