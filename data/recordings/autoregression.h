#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pendular {

/// Plain mean of samples, in the unit of the samples.
double plain_mean(std::span<const double> samples);

/// Lagged covariances C(t) of two series: covariance of one series with the other t samples later,
/// averaged over both directions, in the product of the series' units. The lag t is a number of
/// samples. Each lag is computed when it is first needed, since most are never needed; from
/// `lags_alone` on, all lags are computed at once, by Fourier transforms.
class LaggedCovariances {
  public:
    /// @param second series as long as `first`
    LaggedCovariances(std::span<const double> first, std::span<const double> second);

    /// First lag [samples] from which on all lags are computed at once.
    static constexpr std::size_t lags_alone = 512;

    /// C at a lag [samples], in the product of the series' units.
    double operator()(std::size_t lag);
    /// Sum of the covariances over all lags from -window to window, C(0) + 2 sum_{t=1}^{window}
    /// C(t), in the product of the series' units; `window` is a number of samples.
    double summed(std::size_t window);

  private:
    double at(std::size_t lag) const;
    std::vector<double> all() const;

    std::vector<double> first_, second_, known_;
};

/// Autoregression x_t = sum_j a_j x_(t-j) + innovation, a model of the noise of a series.
struct Autoregression {
    std::vector<double> coefficients = {};  ///< a_j [1]
    double innovation = 0;  ///< variance of the innovation, in the squared unit of the series

    double order() const { return static_cast<double>(coefficients.size()); }
    /// Spectral density at frequency zero for a series of `count` samples: `count` times the
    /// variance of the mean. The sum a of the coefficients is corrected for its bias -(1 + 3 a)/n
    /// (Marriott and Pope 1954, for order 1) and kept below 1 - 2/n.
    double spectrum_at_zero(double count) const;
    /// Spectral density at a frequency in cycles per sample, in the squared unit of the series:
    ///     innovation/|1 - sum_j a_j exp(-2 pi i j frequency)|^2
    /// It is the variance for independent samples.
    double spectrum(double frequency) const;
};

/// Autoregression of order up to 10, and at most a tenth of the n samples, that fits a series best
/// by the Bayesian information criterion. `covariance`: lagged covariances of the series with
/// itself. The innovation is 0 if the series is constant.
Autoregression best_autoregression(LaggedCovariances& covariance, std::size_t n);

}  // namespace pendular
