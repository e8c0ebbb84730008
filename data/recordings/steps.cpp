#include "data/recordings/steps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "data/quantities/statistics.h"
#include "data/recordings/lid_speed.h"

namespace pendular {
namespace {

/// Smallest relative change of a set point that begins a new step [1]. Chosen: above the 1 or 2 %
/// to which controllers hold one.
constexpr double tolerance = 0.05;

using Series = std::span<const double>;

double level(Series series) {
    return median({series.begin(), series.end()});
}

/// Levels (medians) of a series before and after a possible boundary, and the noise around them, in
/// the unit of the series.
struct Sides {
    double before = 0;
    double after = 0;
    double noise = 0;
};

Sides sides(Series before, Series after) {
    return {level(before), level(after),
            std::max(robust_deviation(before), robust_deviation(after))};
}

/// Whether two levels differ by more than 5 % and by more than 3.5 times the noise. For constant
/// levels, the difference of two medians of 20 rows has a standard deviation of 0.4 times the
/// noise. A ramp is no step: between windows it rises by 20 times the change per row, with a noise
/// of 7.4 times this change; nor is a slow wave.
/// @param scale smallest reference of the 5 %, in the unit of the series, so that the noise of a
///        lid at rest makes no steps
bool differ(const Sides& s, double scale) {
    const double reference = std::max({std::abs(s.before), std::abs(s.after), scale});
    return std::abs(s.after - s.before) > std::max(tolerance * reference, 3.5 * s.noise);
}

/// Whether any two levels within a series can differ: not where all of its values lie within 5 %,
/// as in most rows, whose medians are so spared.
bool may_differ(Series series, double scale) {
    const auto [least, greatest] = std::ranges::minmax(series);
    const double nearest_to_zero =
        (least > 0) == (greatest > 0) ? std::min(std::abs(least), std::abs(greatest)) : 0;
    return greatest - least > tolerance * std::max(nearest_to_zero, scale);
}

/// Index in [begin, end) at which a series passes from the level before to the level after: the
/// split with the smallest sum of distances from the two levels.
std::size_t best_split(Series series, std::size_t begin, std::size_t end, const Sides& s) {
    double cost = 0;  // of the split at i + 1, less that at `begin`
    double lowest = 0;
    std::size_t best = begin;
    for (std::size_t i = begin; i < end; ++i) {
        cost += std::abs(series[i] - s.before) - std::abs(series[i] - s.after);
        if (cost < lowest) {
            lowest = cost;
            best = i + 1;
        }
    }
    return best;
}

/// Removes pairs of boundaries around a short excursion, after which the series returns to its
/// level.
std::vector<std::size_t> without_excursions(std::vector<std::size_t> boundaries, Series series,
                                            double scale) {
    for (std::size_t i = 0; i + 1 < boundaries.size();) {
        const std::size_t begin = boundaries[i], end = boundaries[i + 1];
        const std::size_t rows = std::min({shortest_step, begin, series.size() - end});
        const bool back =
            !differ(sides(series.subspan(begin - rows, rows), series.subspan(end, rows)), scale);
        const auto at = boundaries.begin() + static_cast<std::ptrdiff_t>(i);
        if (end - begin < shortest_step && back)
            boundaries.erase(at, at + 2);
        else
            ++i;
    }
    return boundaries;
}

/// Indices of the rows at which a series jumps to another level, found by comparing the
/// `shortest_step` rows before and after each row.
std::vector<std::size_t> jumps(Series series) {
    constexpr std::size_t window = shortest_step;
    std::vector<std::size_t> result;
    if (series.size() < 2 * window) return result;
    const double scale = 0.01 * std::max(std::abs(*std::max_element(series.begin(), series.end())),
                                         std::abs(*std::min_element(series.begin(), series.end())));
    if (!may_differ(series, scale)) return result;
    const auto jumps_at = [&](std::size_t i) {
        return may_differ(series.subspan(i - window, 2 * window), scale) &&
               differ(sides(series.subspan(i - window, window), series.subspan(i, window)), scale);
    };
    const std::size_t last = series.size() - window;
    for (std::size_t i = window; i <= last; ++i) {
        if (!jumps_at(i)) continue;
        std::size_t end = i;  // last of the successive rows that show this jump
        while (end < last && jumps_at(end + 1))
            ++end;
        const Sides s = sides(series.subspan(i - window, window), series.subspan(end, window));
        if (differ(s, scale)) result.push_back(best_split(series, i - window, end + window, s));
        i = end;
    }
    return without_excursions(std::move(result), series, scale);
}

std::vector<Step> between(std::vector<std::size_t> boundaries, std::size_t size) {
    boundaries.insert(boundaries.begin(), 0);
    boundaries.push_back(size);
    std::sort(boundaries.begin(), boundaries.end());
    std::vector<Step> steps;
    for (std::size_t i = 1; i < boundaries.size(); ++i)
        if (boundaries[i] > boundaries[i - 1]) steps.push_back({boundaries[i - 1], boundaries[i]});
    return steps;
}

/// Joins each step with fewer than `shortest_step` rows to the step after it.
std::vector<Step> without_passages(const std::vector<Step>& steps) {
    std::vector<Step> result;
    std::size_t begin = 0;
    for (const Step& step : steps) {
        const bool last = &step == &steps.back();
        if (step.end - step.begin < shortest_step && !last) continue;
        result.push_back({begin, step.end});
        begin = step.end;
    }
    return result;
}

/// Steps of constant speed and normal force within an interval, which an instrument may not
/// number anew where the load changes.
std::vector<Step> steps_within(const Recording& recording, const Step& interval) {
    const std::size_t size = interval.end - interval.begin;
    std::vector<std::size_t> boundaries;
    for (const auto* const column : {&recording.angular_velocity, &recording.normal_force})
        if (!column->empty())  // as without `fill_from_stresses`
            std::ranges::copy(jumps(Series(*column).subspan(interval.begin, size)),
                              std::back_inserter(boundaries));
    std::vector<Step> steps = without_passages(between(boundaries, size));
    if (!recording.angular_velocity.empty()) {
        const auto speeds = Series(recording.angular_velocity).subspan(interval.begin, size);
        for (const auto& [begin, end] : steps)
            for (const std::size_t row : breaks_of_speed(speeds.subspan(begin, end - begin)))
                boundaries.push_back(begin + row);
        steps = without_passages(between(std::move(boundaries), size));
    }
    for (Step& step : steps) {
        step.begin += interval.begin;
        step.end += interval.begin;
    }
    return steps;
}

bool all_known(const std::vector<double>& values, std::size_t size) {
    return values.size() == size &&
           std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

std::vector<Step> split_steps(const Recording& recording) {
    std::vector<std::size_t> boundaries;
    for (std::size_t i = 1; i < recording.interval.size(); ++i)
        if (recording.interval[i] != recording.interval[i - 1]) boundaries.push_back(i);
    std::vector<Step> steps;
    for (const Step& interval : between(boundaries, recording.size()))
        std::ranges::copy(steps_within(recording, interval), std::back_inserter(steps));
    return steps;
}

std::vector<Step> steps_of(const IntervalSeries& series) {
    Recording recording;
    recording.angular_velocity = series.angular_velocity;
    recording.normal_force = series.normal();
    if (!all_known(recording.angular_velocity, series.size()) ||
        !all_known(recording.normal_force, series.size()))
        return {{.begin = 0, .end = series.size()}};
    recording.line = series.line;
    return split_steps(recording);
}

namespace {

/// End of the transient, which lasts until the lid has the speed of the step at least.
std::optional<std::size_t> end_of_transient_at_speed(RecordedStep& step) {
    if (step.at_speed == 0) return end_of_transient(step.series, step.unsteady);
    auto end = end_of_transient(step.series.from(step.at_speed), step.unsteady);
    if (end) *end += step.at_speed;
    return end;
}

}  // namespace

void find_periods(RecordedStep& step) {
    const auto part = level_part(step);
    if (!part) return;
    step.periodic = periodic_columns(*part);
    if (step.steady) step.beyond_whole_turns = whole_turns_begin(*part, step.periodic);
}

std::vector<RecordedStep> recorded_steps(const Recording& recording) {
    std::vector<RecordedStep> result;
    for (const Step& rows : split_steps(recording)) {
        RecordedStep step{.rows = rows,
                          .number = static_cast<int>(result.size()) + 1,
                          .series = step_series(recording, rows)};
        step.spikes = take_out_spikes(step.series);
        step.at_speed = begin_at_speed(step.series.angular_velocity);
        step.lid_turns = turns(std::span(step.series.angular_velocity).subspan(step.at_speed));
        if (step.series.size() - step.at_speed >= shortest_step && step.lid_turns)
            step.steady = end_of_transient_at_speed(step);
        find_periods(step);
        result.push_back(std::move(step));
    }
    return result;
}

std::optional<StepSeries> level_part(const RecordedStep& step) {
    if (!step.lid_turns) return std::nullopt;
    const std::size_t begin = step.steady.value_or(step.series.size() / 2);
    if (step.series.size() - begin < shortest_step) return std::nullopt;
    return step.series.from(begin);
}

}  // namespace pendular
