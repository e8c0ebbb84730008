#include "data/recordings/findings/harmonics.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "data/recordings/autoregression.h"
#include "data/recordings/time_series.h"

namespace pendular {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
/// Below one and a half turns, a wobble of one period a turn is hardly told from a trend. Eight
/// samples a turn are four for each period of the fastest harmonic.
constexpr double least_turns = 1.5, least_samples_per_turn = 8;
constexpr std::size_t least_samples = 40;  ///< twice `shortest_step`: chosen
constexpr int highest_per_turn = 2;        ///< a tilt or bend of the lid shows once or twice a turn
/// Numbers of neighbouring frequencies that the noise is estimated from; the larger of the two
/// p values counts. The narrow window follows spectra that bend within 12 frequencies, such as
/// those of moving averages over a tenth of a step; the wide one has more degrees of freedom.
constexpr int windows[] = {6, 12};
/// Largest order of the autoregressive model by which the noise is whitened. Chosen: an
/// information criterion takes fewer where they suffice.
constexpr std::size_t highest_order = 20;
/// Degrees of freedom of the noise for each period of the wobble, at most. Below the frequency of a
/// wobble over few turns, there are few frequencies or none, and the trend and the wobble
/// themselves are taken out there: how far the spectrum rises towards zero is not known. Without a
/// limit, 22 of 100 studies with noise behind a low-pass filter gave a wobble, all over fewer than
/// 3 turns.
constexpr double freedom_per_period = 0.7;
/// p value of a periodic part below which means are taken over whole turns [1]. Chosen: means over
/// whole turns cost up to a turn of rows, which is no loss only where the wobble is certain.
constexpr double certain_wobble = 1e-3;

double turns_covered(std::span<const double> angle) {
    const double n = static_cast<double>(angle.size());
    return std::abs(angle.back() - angle.front()) / whole_turn * n / (n - 1);
}

bool enough_turns(std::span<const double> angle) {
    if (angle.size() < least_samples) return false;
    const double turns = turns_covered(angle);
    return turns >= least_turns &&
           static_cast<double>(angle.size()) >= least_samples_per_turn * turns;
}

/// Constant, line, and cosine and sine of each harmonic at each sample.
Eigen::MatrixXd harmonic_columns(std::span<const double> angle) {
    const auto n = static_cast<Eigen::Index>(angle.size());
    const Eigen::Map<const Eigen::ArrayXd> phase(angle.data(), n);
    Eigen::MatrixXd columns(n, Eigen::Index{2} * (1 + highest_per_turn));
    columns.col(0).setOnes();
    columns.col(1).setLinSpaced(n, -1, 1);
    for (int q = 1; q <= highest_per_turn; ++q) {
        const Eigen::Index cosine = Eigen::Index{2} * q;
        columns.col(cosine) = (q * phase).cos();
        columns.col(cosine + 1) = (q * phase).sin();
    }
    return columns;
}

/// exp(i q angle) at each sample, for q periods per turn.
Eigen::ArrayXcd wave(std::span<const double> angle, double q) {
    const Eigen::Map<const Eigen::ArrayXd> phase(angle.data(), std::ssize(angle));
    Eigen::ArrayXcd result(phase.size());
    result.real() = (q * phase).cos();
    result.imag() = (q * phase).sin();
    return result;
}

/// Squared amplitude of the periodic part of residuals that has the phase of `wave`.
double squared_amplitude(const Eigen::VectorXd& residuals, const Eigen::ArrayXcd& wave) {
    const double scale = 2 / static_cast<double>(residuals.size());
    return std::norm(scale * (wave * residuals.array()).sum());
}

/// Values after a filter that makes noise of an autoregressive model white; the first values, as
/// many as the model has coefficients, are left out.
Eigen::VectorXd whitened(const Autoregression& noise, const Eigen::VectorXd& values) {
    const Eigen::Index order = std::ssize(noise.coefficients), left = values.size() - order;
    Eigen::VectorXd result = values.tail(left);
    for (Eigen::Index j = 0; j < order; ++j)
        result -=
            noise.coefficients[static_cast<std::size_t>(j)] * values.segment(order - 1 - j, left);
    return result;
}

/// Least-squares fit of harmonics to a series after both were whitened.
struct WhitenedFit {
    Autoregression noise;
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd unit_covariance;  ///< of the coefficients, for white noise of variance 1
    Eigen::VectorXd residuals;        ///< whitened
};

WhitenedFit whitened_fit(const Autoregression& noise, const Eigen::VectorXd& values,
                         const Eigen::MatrixXd& columns) {
    Eigen::MatrixXd white(columns.rows() - std::ssize(noise.coefficients), columns.cols());
    for (Eigen::Index c = 0; c < columns.cols(); ++c)
        white.col(c) = whitened(noise, columns.col(c));
    const Eigen::VectorXd left = whitened(noise, values);
    WhitenedFit fit{
        noise, white.colPivHouseholderQr().solve(left), (white.transpose() * white).inverse(), {}};
    fit.residuals = left - white * fit.coefficients;
    return fit;
}

/// Fits harmonics and the spectrum of the noise in turns (Cochrane and Orcutt). The steep spectrum
/// of strongly correlated noise leaks into the amplitudes of a plain fit, far above the noise at
/// their frequency; whitened noise has little to leak.
WhitenedFit whitened_fit(const Eigen::VectorXd& values, const Eigen::MatrixXd& columns) {
    constexpr int turns_taken =
        3;  // the first two leave the wobble, then its leakage, in the noise
    const auto highest = std::min(highest_order, static_cast<std::size_t>(values.size() / 10));
    const Eigen::MatrixXd line = columns.leftCols(2);
    Eigen::VectorXd noise = values - line * line.householderQr().solve(values);
    WhitenedFit fit;
    for (int k = 0; k < turns_taken; ++k) {
        fit = whitened_fit(
            burg_autoregression({noise.data(), static_cast<std::size_t>(noise.size())}, highest),
            values, columns);
        noise = values - columns * fit.coefficients;
        noise.array() -= noise.mean();
    }
    return fit;
}

/// Spectrum of white residuals at frequencies near q periods per turn, with the number of these
/// frequencies. Frequencies next to those of the harmonics are left out, since the fit of the
/// harmonics took away their power.
struct NoiseLevel {
    double spectrum = 0;
    int frequencies = 0;
};

NoiseLevel noise_near(int q, const Eigen::VectorXd& residuals, std::span<const double> angle,
                      int most) {
    const double n = static_cast<double>(angle.size()), turns = turns_covered(angle);
    const int centre = static_cast<int>(std::lround(q * turns));
    const auto of_harmonic = [&](double per_turn) {
        const double nearest = std::round(per_turn);
        return std::abs(per_turn - nearest) * turns < 0.75 && nearest <= highest_per_turn;
    };
    double sum = 0;
    int count = 0;
    const auto add = [&](int k, const Eigen::ArrayXcd& at_k) {
        // The highest frequency that n samples resolve is k = n/2.
        if (k < 1 || k > 0.45 * n || count >= most || of_harmonic(k / turns)) return;
        sum += n * squared_amplitude(residuals, at_k) / 4;
        ++count;
    };
    // Waves of neighbouring frequencies differ by one factor, which is cheaper than a sine.
    const Eigen::ArrayXcd next = wave(angle, 1 / turns);
    Eigen::ArrayXcd below = wave(angle, centre / turns), above = below;
    for (int away = 1; away < n / 2 && count < most; ++away) {
        below *= next.conjugate();
        above *= next;
        add(centre - away, below);
        add(centre + away, above);
    }
    return {count > 0 ? sum / count : 0, count};
}

/// Test of the harmonic with q periods per turn against the noise at `most` frequencies near it;
/// empty if there are none.
std::optional<Harmonic> tested(int q, const WhitenedFit& fit, std::span<const double> angle,
                               int most) {
    const NoiseLevel level = noise_near(q, fit.residuals, angle, most);
    if (level.frequencies == 0) return std::nullopt;
    const Eigen::Index cosine = Eigen::Index{2} * q;
    const Eigen::Matrix2d of_waves =
        level.spectrum * fit.unit_covariance.block<2, 2>(cosine, cosine);
    const Eigen::Vector2d waves = fit.coefficients.segment<2>(cosine);
    const double f = waves.dot(of_waves.inverse() * waves) / 2;
    const double k = std::min<double>(level.frequencies,
                                      std::max(1.0, freedom_per_period * q * turns_covered(angle)));
    return Harmonic{q, waves.norm(), std::sqrt(of_waves.trace() / 2), std::pow(1 + f / k, -k)};
}

/// Columns of a recording in which a wobble may show.
struct WobblingColumn {
    const char* quantity;
    std::vector<double> StepSeries::*values;
};
constexpr WobblingColumn wobbling_columns[] = {{"torque", &StepSeries::torque},
                                               {"normal_force", &StepSeries::normal_force},
                                               {"height", &StepSeries::height}};

/// Number of samples to leave out at the beginning so that a whole number of turns remains.
std::size_t samples_beyond_whole_turns(std::span<const double> angle) {
    const double per_turn = static_cast<double>(angle.size()) / turns_covered(angle);
    const double whole = std::floor(turns_covered(angle)) * per_turn;
    return angle.size() - static_cast<std::size_t>(std::lround(whole));
}

}  // namespace

std::vector<double> rotation_angle(const StepSeries& series) {
    std::vector<double> angle = {0};
    for (std::size_t k = 1; k < series.size(); ++k)
        angle.push_back(angle.back() +
                        (series.angular_velocity[k] + series.angular_velocity[k - 1]) / 2 *
                            (series.time[k] - series.time[k - 1]));
    return angle;
}

std::vector<Harmonic> harmonics(std::span<const double> samples, std::span<const double> angle) {
    if (!enough_turns(angle)) return {};
    const Eigen::Map<const Eigen::VectorXd> values(samples.data(), std::ssize(samples));
    const WhitenedFit fit = whitened_fit(values, harmonic_columns(angle));
    const double rounding = 1e-12 * values.cwiseAbs().maxCoeff();
    if (!(fit.noise.innovation > rounding * rounding)) return {};
    const auto left = angle.subspan(fit.noise.coefficients.size());
    std::vector<Harmonic> result;
    for (int q = 1; q <= highest_per_turn; ++q) {
        std::optional<Harmonic> least_certain;
        for (const int most : windows) {
            const auto each = tested(q, fit, left, most);
            if (each && (!least_certain || each->p >= least_certain->p)) least_certain = each;
        }
        if (least_certain) result.push_back(*least_certain);
    }
    return result;
}

std::vector<PeriodicColumn> periodic_columns(const StepSeries& series) {
    const std::vector<double> angle = rotation_angle(series);
    if (!enough_turns(angle)) return {};
    std::vector<PeriodicColumn> result;
    for (const WobblingColumn& column : wobbling_columns) {
        const std::vector<double>& values = series.*column.values;
        result.push_back({column.quantity, plain_mean(values),
                          mean_of_correlated(values).standard_error, harmonics(values, angle)});
    }
    return result;
}

std::size_t whole_turns_begin(const StepSeries& steady,
                              const std::vector<PeriodicColumn>& columns) {
    const bool biased = std::ranges::any_of(columns, [](const PeriodicColumn& column) {
        return std::ranges::any_of(column.harmonics, [&](const Harmonic& h) {
            return h.p < certain_wobble && h.amplitude > column.mean_error;
        });
    });
    return biased ? samples_beyond_whole_turns(rotation_angle(steady)) : 0;
}

}  // namespace pendular
