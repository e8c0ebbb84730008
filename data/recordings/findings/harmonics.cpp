#include "data/recordings/findings/harmonics.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "data/recordings/autoregression.h"
#include "data/recordings/time_series.h"

namespace pendular {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double least_turns = 1.5, least_samples_per_turn = 8;
constexpr std::size_t least_samples = 40;
constexpr int highest_per_turn = 2, most_neighbours = 20;
/// p value of a periodic part below which means are taken over whole turns [1].
constexpr double certain_wobble = 1e-3;

double turns_covered(std::span<const double> angle) {
    const double n = static_cast<double>(angle.size());
    return std::abs(angle.back() - angle.front()) / turn * n / (n - 1);
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

/// Mean ratio of the power of residuals to the spectrum of their noise at frequencies near q
/// periods per turn, with the number of these frequencies. Frequencies next to those of the
/// harmonics are left out, since the fit of the harmonics took away their power.
struct NoiseLevel {
    double ratio = 1;
    int frequencies = 0;
};

NoiseLevel noise_near(int q, const Eigen::VectorXd& residuals, std::span<const double> angle,
                      const Autoregression& noise) {
    const double n = static_cast<double>(angle.size()), turns = turns_covered(angle);
    const int centre = static_cast<int>(std::lround(q * turns));
    const auto of_harmonic = [&](double per_turn) {
        const double nearest = std::round(per_turn);
        return std::abs(per_turn - nearest) * turns < 0.75 && nearest <= highest_per_turn;
    };
    double sum = 0;
    int count = 0;
    const auto add = [&](int k, const Eigen::ArrayXcd& at_k) {
        if (k < 1 || k > 0.45 * n || count >= most_neighbours || of_harmonic(k / turns)) return;
        sum += n * squared_amplitude(residuals, at_k) / (4 * noise.spectrum(k / n));
        ++count;
    };
    // Waves of neighbouring frequencies differ by one factor, which is cheaper than a sine.
    const Eigen::ArrayXcd next = wave(angle, 1 / turns);
    Eigen::ArrayXcd below = wave(angle, centre / turns), above = below;
    for (int away = 1; away < n / 2 && count < most_neighbours; ++away) {
        below *= next.conjugate();
        above *= next;
        add(centre - away, below);
        add(centre + away, above);
    }
    return {count > 0 ? sum / count : 1, count};
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
    const auto n = static_cast<Eigen::Index>(samples.size());
    const Eigen::Map<const Eigen::VectorXd> values(samples.data(), n);
    const Eigen::MatrixXd columns = harmonic_columns(angle);
    const Eigen::VectorXd fit = columns.colPivHouseholderQr().solve(values);
    // Over a part of a turn, the columns are not orthogonal.
    const Eigen::MatrixXd unit_covariance = (columns.transpose() * columns).inverse();
    const Eigen::VectorXd residuals = values - columns * fit;
    const std::span<const double> left(residuals.data(), samples.size());
    LaggedCovariances covariance(left, left);
    const Autoregression noise = best_autoregression(covariance, samples.size());
    const double rounding = 1e-12 * values.cwiseAbs().maxCoeff();
    if (noise.innovation <= rounding * rounding) return {};

    std::vector<Harmonic> result;
    const double count = static_cast<double>(n);
    for (int q = 1; q <= highest_per_turn; ++q) {
        const NoiseLevel level = noise_near(q, residuals, angle, noise);
        if (level.frequencies == 0) continue;
        const double spectrum = level.ratio * noise.spectrum(q * turns_covered(angle) / count);
        const Eigen::Index cosine = Eigen::Index{2} * q;
        const Eigen::Matrix2d of_waves = spectrum * unit_covariance.block<2, 2>(cosine, cosine);
        const Eigen::Vector2d waves = fit.segment<2>(cosine);
        const double amplitude = waves.norm();
        const double f = waves.dot(of_waves.inverse() * waves) / 2, k = level.frequencies;
        result.push_back({q, amplitude, std::sqrt(of_waves.trace() / 2), std::pow(1 + f / k, -k)});
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
