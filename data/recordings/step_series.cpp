#include "data/recordings/step_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "data/quantities/statistics.h"
#include "data/recordings/lid_speed.h"
#include "data/recordings/spikes.h"
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
    // Chosen: noise of a small torque must not end an import, a torque that turns round must.
    const double far = 5 * robust_deviation(series);
    if (std::ranges::any_of(magnitudes, [&](double value) { return value > far; })) return true;
    if (magnitudes.size() < std::max<std::size_t>(3, series.size() / 50)) return false;
    const double typical = median(magnitudes);
    return typical > 3 * robust_deviation(magnitudes) || typical > 5 * sample_noise(series);
}

/// Changes the sign of a negative torque. Does nothing while the lid rests, when the torque may
/// relax through zero, also in the rows before the lid has the speed of the step.
/// @throws InputError if the torque has both signs by more than noise
void check_torque_sign(StepSeries& series, const Recording& recording, const Step& step) {
    const std::size_t begin = begin_at_speed(series.angular_velocity);
    if (!turns(std::span(series.angular_velocity).subspan(begin))) return;
    std::vector<double> without_spikes = series.torque;
    const auto [least, greatest] = std::ranges::minmax(series.torque);
    // Single values of the other sign are spikes.
    if (least < 0 && greatest > 0) replace_spikes(without_spikes);
    const auto torques = std::span(without_spikes).subspan(begin);
    std::vector<double> positive, negative;
    for (const double torque : torques) {
        if (torque > 0) positive.push_back(torque);
        if (torque < 0) negative.push_back(-torque);
    }
    const bool mostly_negative = negative.size() > positive.size();
    if (significant(mostly_negative ? positive : negative, torques)) {
        std::size_t row = step.begin + begin;
        for (const double torque : torques) {
            if (mostly_negative ? torque > 0 : torque < 0) break;
            ++row;
        }
        throw InputError({recording.file, recording.line[row]},
                         "the torque changes its sign within a step of constant set points; split "
                         "the step here, by a column 'Interval [1]', or correct the sign; if the "
                         "number stands for no value, write missing = [\"...\"] with it below "
                         "[[recording]]");
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
    // A drift by 0.1 % is small beside the error of any reading.
    const auto found = end_of_transient(series);
    if (!found && nearly_constant(series)) return series.size() / 2;
    return found;
}

}  // namespace

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

namespace {

/// Means of the first and last quarter of the gaps of a step; their centres are three quarters of
/// the step apart.
std::pair<Mean, Mean> end_quarters(const StepSeries& series) {
    const std::span<const double> height = series.height;
    return {mean_of_correlated(height.first(height.size() / 4)),
            mean_of_correlated(height.last(height.size() / 4))};
}

}  // namespace

std::optional<Creep> creep_of(const StepSeries& series) {
    const auto begin = end_of_transient_or_drift(series.torque);
    if (!begin || series.size() - *begin < shortest_step) return std::nullopt;
    const auto [before, after] = end_quarters(series.from(*begin));
    const double scale = 1 / (0.75 * 0.5 * (after.value + before.value));
    const Creep creep{*begin, scale * (after.value - before.value),
                      scale * std::hypot(before.standard_error, after.standard_error)};
    if (std::abs(creep.change) > most_creep) return std::nullopt;
    return creep;
}

namespace {

double middle(std::span<const double> speeds) {
    return std::abs(median({speeds.begin(), speeds.end()}));
}

}  // namespace

double SpeedRamp::factor() const {
    const auto [least, most] = std::minmax(first, last);
    return least > 0 ? most / least : std::numeric_limits<double>::infinity();
}

std::string SpeedRamp::change() const {
    const double by = factor();
    if (!std::isfinite(by)) return "from or to rest";
    return fmt::format("by a factor of {:.{}f}", by, by < 10 ? 1 : 0);
}

SpeedRamp extreme_speeds(std::span<const double> speeds) {
    std::vector<double> sorted;
    for (const double speed : speeds)
        sorted.push_back(std::abs(speed));
    std::ranges::sort(sorted);
    // Two values may be spikes.
    const std::size_t aside = std::min<std::size_t>(2, (sorted.size() - 1) / 2);
    return {sorted[aside], sorted[sorted.size() - 1 - aside]};
}

std::optional<SpeedRamp> speed_ramp(std::span<const double> speeds) {
    if (speeds.size() < shortest_step) return std::nullopt;
    // The medians of the last two quarters of a ramp differ by half of the change over the half.
    const std::size_t quarter = speeds.size() / 4;
    const auto last = speeds.last(quarter), before = speeds.last(2 * quarter).first(quarter);
    const double change = std::abs(middle(last) - middle(before));
    // The difference of two medians of independent values scatters by 1.8 noise/sqrt(quarter).
    const double noise = std::max(sample_noise(last), sample_noise(before));
    // Rounding moves a median by one step.
    const auto both = speeds.last(2 * quarter);
    const bool changes = change > 0.5 * settled_speed * std::max(middle(last), middle(before)) &&
                         change > 5 * noise / std::sqrt(static_cast<double>(quarter)) &&
                         change > 1.5 * least_step({both.begin(), both.end()});
    if (!changes) return std::nullopt;
    constexpr std::size_t rows = 3;  // their median is not moved by one spike
    const SpeedRamp ends{middle(speeds.first(rows)), middle(speeds.last(rows))};
    return ends.factor() > 1 + settled_speed ? ends : extreme_speeds(speeds);
}

namespace {

/// Medians of `rows` successive values each, which neither noise nor a spike moves by much.
std::vector<double> medians_of(std::span<const double> values, std::size_t rows) {
    std::vector<double> medians;
    for (std::size_t i = 0; i + rows <= values.size(); i += rows)
        medians.push_back(middle(values.subspan(i, rows)));
    return medians;
}

}  // namespace

std::optional<SpeedRamp> varying_speed(std::span<const double> angular_velocity) {
    if (const auto ramp = speed_ramp(angular_velocity)) return ramp;
    constexpr std::size_t rows = 5;
    const auto part = angular_velocity.subspan(begin_at_speed(angular_velocity));
    if (part.size() < shortest_step) return std::nullopt;
    const SpeedRamp ends = extreme_speeds(medians_of(part, rows));
    if (ends.factor() <= (1 + settled_speed) / (1 - settled_speed)) return std::nullopt;
    // The median of five values scatters by half of the noise, and rounding moves it by one step.
    const double by_chance =
        std::max(5 * sample_noise(part), 3 * least_step({part.begin(), part.end()}));
    return ends.last - ends.first > by_chance ? std::optional(ends) : std::nullopt;
}

std::vector<std::size_t> take_out_spikes(StepSeries& series) {
    std::set<std::size_t> changed;
    for (std::vector<double>* column : {&series.torque, &series.normal_force, &series.height})
        std::ranges::copy(replace_spikes(*column), std::inserter(changed, changed.end()));
    // A smaller spike of the speed changes neither the mean nor the torque.
    std::ranges::copy(replace_spikes(series.angular_velocity, settled_speed),
                      std::inserter(changed, changed.end()));
    return {changed.begin(), changed.end()};
}

namespace {

/// Means of successive parts of a series, each of size/parts samples; samples that fill no part are
/// left out.
std::vector<double> part_means(const std::vector<double>& series, std::size_t parts) {
    const std::size_t size = std::max<std::size_t>(1, series.size() / parts);
    std::vector<double> means;
    for (std::size_t i = 0; i + size <= series.size(); i += size)
        means.push_back(mean_of_correlated(std::span(series).subspan(i, size)).value);
    return means;
}

/// Relative change of the mean from the first to the last quarter of a series [1].
double relative_change(const std::vector<double>& series) {
    const std::vector<double> quarters = part_means(series, 4);
    return quarters.front() == 0 ? 0 : quarters.back() / quarters.front() - 1;
}

}  // namespace

double strain_of(const StepSeries& series, const AnnularCell& cell) {
    const double rate = shear_rate(std::abs(mean_of_correlated(series.angular_velocity).value),
                                   mean_of_correlated(series.height).value, cell);
    return rate * (series.time.back() - series.time.front());
}

Remark::Kind looks_like(const StepSeries& series) {
    using enum Remark::Kind;
    // Chosen: the limits decide words in a message alone.
    const double force = relative_change(series.normal_force);
    if (force < -0.2) return unloading;
    if (force > 0.2) return loading;
    if (relative_change(series.height) < -0.01) return consolidation;
    const std::vector<double> torque = part_means(series.torque, 20);
    const auto peak = std::ranges::max_element(torque);
    const bool early = peak - torque.begin() < 3 * static_cast<std::ptrdiff_t>(torque.size()) / 4;
    if (early && torque.back() < 0.95 * *peak) return shear_to_failure;
    return torque.back() > 1.05 * torque[torque.size() / 2] ? stopped_shear : preshear;
}

}  // namespace pendular
