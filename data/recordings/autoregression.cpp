#include "data/recordings/autoregression.h"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

namespace pendular {
namespace {

std::vector<double> centred(std::span<const double> samples) {
    std::vector<double> result(samples.begin(), samples.end());
    const double mean = plain_mean(samples);
    for (double& sample : result)
        sample -= mean;
    return result;
}

/// Autoregression with one more coefficient, by the recursion of Levinson and Durbin. `biased`
/// returns the covariance at a lag, divided by n at all lags, which keeps the recursion stable.
template <typename Lagged>
Autoregression grown(const Autoregression& model, const Lagged& biased) {
    const std::size_t order = model.coefficients.size() + 1;
    double reflection = biased(order);
    for (std::size_t j = 1; j < order; ++j)
        reflection -= model.coefficients[j - 1] * biased(order - j);
    reflection /= model.innovation;
    std::vector<double> next(order, reflection);
    for (std::size_t j = 1; j < order; ++j)
        next[j - 1] = model.coefficients[j - 1] - reflection * model.coefficients[order - j - 1];
    return {std::move(next), model.innovation * (1 - reflection * reflection)};
}

}  // namespace

double plain_mean(std::span<const double> samples) {
    double sum = 0;
    for (double sample : samples)
        sum += sample;
    return sum / static_cast<double>(samples.size());
}

LaggedCovariances::LaggedCovariances(std::span<const double> first, std::span<const double> second)
    : first_(centred(first)), second_(centred(second)) {}

double LaggedCovariances::operator()(std::size_t lag) {
    if (lag >= first_lag_by_fourier_transform && known_.size() < first_.size()) known_ = all();
    while (known_.size() <= lag)
        known_.push_back(at(known_.size()));
    return known_[lag];
}

double LaggedCovariances::summed(std::size_t window) {
    double sum = (*this)(0);
    for (std::size_t lag = 1; lag <= window; ++lag)
        sum += 2 * (*this)(lag);
    return sum;
}

double LaggedCovariances::at(std::size_t lag) const {
    const std::size_t pairs = first_.size() - lag;
    double sum = 0;
    for (std::size_t i = 0; i < pairs; ++i)
        sum += first_[i] * second_[i + lag] + first_[i + lag] * second_[i];
    return sum / (2 * static_cast<double>(pairs));
}

std::vector<double> LaggedCovariances::all() const {
    const std::size_t n = first_.size(), padded = std::bit_ceil(2 * n);
    std::vector<double> a = first_, b = second_, sums;
    a.resize(padded);  // zeros, so that no lag wraps around
    b.resize(padded);
    std::vector<std::complex<double>> of_a, of_b;
    Eigen::FFT<double> transform;
    transform.fwd(of_a, a);
    transform.fwd(of_b, b);
    for (std::size_t k = 0; k < of_a.size(); ++k)
        of_a[k] = std::conj(of_a[k]) * of_b[k];
    transform.inv(sums, of_a);
    std::vector<double> covariances{at(0)};
    for (std::size_t lag = 1; lag < n; ++lag)
        covariances.push_back((sums[lag] + sums[padded - lag]) /
                              (2 * static_cast<double>(n - lag)));
    return covariances;
}

double Autoregression::spectrum_at_zero(double count) const {
    double sum = 0;
    for (const double a : coefficients)
        sum += a;
    if (!coefficients.empty()) sum = std::min(sum + (1 + 3 * sum) / count, 1 - 2 / count);
    return innovation * count / (count - 1 - order()) / ((1 - sum) * (1 - sum));
}

double Autoregression::spectrum(double frequency) const {
    std::complex<double> transfer = 1;
    for (std::size_t j = 0; j < coefficients.size(); ++j)
        transfer -= coefficients[j] *
                    std::polar(1.0, -2 * std::numbers::pi * frequency * static_cast<double>(j + 1));
    return innovation / std::norm(transfer);
}

Autoregression best_autoregression(LaggedCovariances& covariance, std::size_t n) {
    const double count = static_cast<double>(n);
    const std::size_t highest = std::min<std::size_t>(10, n / 10);
    const auto biased = [&](std::size_t lag) {
        return covariance(lag) * (count - static_cast<double>(lag)) / count;
    };
    Autoregression model{{}, biased(0)};
    Autoregression chosen = model;
    if (model.innovation <= 0) return chosen;
    double best = count * std::log(model.innovation);
    while (model.coefficients.size() < highest) {
        model = grown(model, biased);
        if (model.innovation <= 0) break;  // deterministic series
        const double criterion =
            count * std::log(model.innovation) + std::log(count) * model.order();
        if (criterion >= best) continue;
        best = criterion;
        chosen = model;
    }
    return chosen;
}

Autoregression burg_autoregression(std::span<const double> samples, std::size_t highest) {
    const Eigen::Index n = std::ssize(samples);
    const double count = static_cast<double>(n);
    Eigen::VectorXd forward = Eigen::Map<const Eigen::VectorXd>(samples.data(), n),
                    backward = forward;
    Autoregression model{{}, forward.squaredNorm() / count};
    Autoregression chosen = model;
    double best = count * std::log(model.innovation);
    for (std::size_t order = 1; order <= highest && model.innovation > 0; ++order) {
        const Eigen::Index left = n - static_cast<Eigen::Index>(order);
        const Eigen::VectorXd ahead = forward.tail(left), behind = backward.head(left);
        const double reflection =
            2 * ahead.dot(behind) / (ahead.squaredNorm() + behind.squaredNorm());
        std::vector<double> next(order, reflection);
        for (std::size_t j = 1; j < order; ++j)
            next[j - 1] =
                model.coefficients[j - 1] - reflection * model.coefficients[order - 1 - j];
        model = {std::move(next), model.innovation * (1 - reflection * reflection)};
        forward = ahead - reflection * behind;
        backward = behind - reflection * ahead;
        const double criterion =
            count * std::log(model.innovation) + std::log(count) * model.order();
        if (!(criterion < best)) continue;
        best = criterion;
        chosen = model;
    }
    return chosen;
}

}  // namespace pendular
