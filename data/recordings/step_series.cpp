#include "data/recordings/step_series.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "data/recordings/robust.h"
#include "data/recordings/time_series.h"

namespace pendular {
namespace {

/// Whether times are evenly spaced: each spacing is 0.5 to 1.5 times the median spacing, to allow
/// for jitter and rounding. True also if most neighbouring times are equal, being recorded too
/// coarsely.
bool evenly_spaced(const std::vector<double>& time) {
    std::vector<double> spacings;
    for (std::size_t i = 1; i < time.size(); ++i)
        spacings.push_back(time[i] - time[i - 1]);
    const double usual = median(spacings);
    const auto [least, most] = std::minmax_element(spacings.begin(), spacings.end());
    return usual == 0 || (*least >= 0.5 * usual && *most <= 1.5 * usual);
}

/// Evenly spaced times, as many as there are rows, with their places among the rows.
struct Grid {
    std::vector<double> time;      ///< [s]
    std::vector<std::size_t> row;  ///< index of the last row at or before each time
    std::vector<double> fraction;  ///< part of the way from this row to the next row [1]
};

Grid even_grid(const std::vector<double>& time) {
    Grid grid;
    const std::size_t n = time.size();
    std::size_t row = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = time.front() + (time.back() - time.front()) * static_cast<double>(i) /
                                            static_cast<double>(n - 1);
        while (row + 2 < n && time[row + 1] <= t)
            ++row;
        const double spacing = time[row + 1] - time[row];
        grid.time.push_back(t);
        grid.row.push_back(row);
        grid.fraction.push_back(spacing > 0 ? std::min((t - time[row]) / spacing, 1.0) : 0);
    }
    return grid;
}

void interpolate(std::vector<double>& values, const Grid& grid) {
    std::vector<double> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t row = grid.row[i];
        result.push_back(std::lerp(values[row], values[row + 1], grid.fraction[i]));
    }
    values = std::move(result);
}

void space_evenly(StepSeries& series) {
    const Grid grid = even_grid(series.time);
    for (auto* values :
         {&series.torque, &series.normal_force, &series.height, &series.angular_velocity})
        interpolate(*values, grid);
    std::vector<int> line;
    for (const std::size_t row : grid.row)
        line.push_back(series.line[row]);
    line.back() = series.line.back();
    series.line = std::move(line);
    series.time = grid.time;
    series.interpolated = true;
}

/// Whether the values of one sign are more than noise around zero: at least one value is far
/// outside of the noise; or there are more than a few values, and their median is far from zero,
/// compared with their spread or with the noise from sample to sample of the series.
/// @param magnitudes absolute values of the values of this sign
/// @param series all values, of both signs
bool significant(const std::vector<double>& magnitudes, std::span<const double> series) {
    const double far = 5 * robust_deviation(series);
    if (std::ranges::any_of(magnitudes, [&](double value) { return value > far; })) return true;
    if (magnitudes.size() < std::max<std::size_t>(3, series.size() / 50)) return false;
    const double typical = median(magnitudes);
    return typical > 3 * robust_deviation(magnitudes) || typical > 5 * sample_noise(series);
}

/// Changes the sign of a negative torque. Does nothing while the lid rests, when the torque may
/// relax through zero.
/// @throws InputError if the torque has both signs by more than noise
void check_torque_sign(StepSeries& series, const Recording& recording, const Step& step) {
    if (!turns(mean_of_correlated(series.angular_velocity))) return;
    std::vector<double> positive, negative;
    for (const double torque : series.torque) {
        if (torque > 0) positive.push_back(torque);
        if (torque < 0) negative.push_back(-torque);
    }
    const bool mostly_negative = negative.size() > positive.size();
    if (significant(mostly_negative ? positive : negative, series.torque)) {
        std::size_t row = step.begin;
        while (mostly_negative ? recording.torque[row] <= 0 : recording.torque[row] >= 0)
            ++row;
        throw InputError({recording.file, recording.line[row]},
                         "the torque changes its sign within a step of constant set points; split "
                         "the step here, by a column 'Interval [1]', or correct the sign");
    }
    series.flipped = mostly_negative;
    if (mostly_negative)
        for (double& torque : series.torque)
            torque = -torque;
}

/// Whether the means of the last two quarters of a series differ by less than 0.1 %.
bool nearly_constant(std::span<const double> series) {
    const std::size_t quarter = series.size() / 4;
    const Mean before = mean_of_correlated(series.last(2 * quarter).first(quarter));
    const Mean after = mean_of_correlated(series.last(quarter));
    return std::abs(after.value - before.value) < 1e-3 * std::abs(after.value);
}

std::optional<std::size_t> end_of_transient_or_drift(std::span<const double> series) {
    const auto found = end_of_transient(series);
    if (!found && nearly_constant(series)) return series.size() / 2;
    return found;
}

}  // namespace

bool turns(const Mean& angular_velocity) {
    return std::abs(angular_velocity.value) > 3 * angular_velocity.standard_error;
}

StepSeries step_series(const Recording& recording, const Step& step) {
    StepSeries series{recording.rows(step.begin, step.end)};
    // The fit reads what was measured, not what the instrument computed from it.
    for (auto* const computed :
         {&series.interval, &series.shear_stress, &series.normal_stress, &series.shear_rate})
        computed->clear();
    check_torque_sign(series, recording, step);
    if (!evenly_spaced(series.time)) space_evenly(series);
    return series;
}

std::optional<std::size_t> end_of_transient(const StepSeries& series, std::string& unsteady) {
    const auto torque = end_of_transient_or_drift(series.torque);
    const auto height = end_of_transient_or_drift(series.height);
    if (torque && height) return std::max(*torque, *height);
    unsteady = torque ? "height" : height ? "torque" : "";
    return std::nullopt;
}

}  // namespace pendular
