#include "data/recordings/steady_state.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "data/quantities/statistics.h"
#include "data/recordings/findings/detectors.h"
#include "data/recordings/findings/drift.h"
#include "data/recordings/lid_speed.h"
#include "data/recordings/step_series.h"
#include "data/recordings/time_series.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Changes of a gap over their standard error [1] from which one step creeps whatever the others
/// do, and from which two steps of one recording do.
constexpr double clear_creep = 4, clear_in_two = 2;

/// Mean change of the gap within a step of a recording [1], if it is significant; 0 otherwise.
double common_drift(const std::string& file, const std::vector<RecordedStep>& steps) {
    for (const Remark& test : drift_tests(step_trends(file, steps), {}))
        if (test.quantity == "height" && test.p < finding_significance) return test.relative;
    return 0;
}

/// Whether the gap of a step creeps, given the creep of all steps of the recording whose gap is not
/// steady.
bool is_creep(const Creep& creep, const std::vector<std::optional<Creep>>& all, double drift) {
    const double size = std::abs(creep.change) / creep.error;
    const auto alike = std::ranges::count_if(all, [&](const std::optional<Creep>& other) {
        return other && other->change * creep.change > 0 &&
               std::abs(other->change) > clear_in_two * other->error;
    });
    return creep.change * drift > 0 || size > clear_creep || (size > clear_in_two && alike >= 2);
}

}  // namespace

void find_creep(const std::string& file, std::vector<RecordedStep>& steps) {
    std::vector<std::optional<Creep>> found(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k)
        if (steps[k].unsteady == "height") found[k] = creep_of(steps[k].series);
    if (std::ranges::none_of(found, &std::optional<Creep>::has_value)) return;
    const double drift = common_drift(file, steps);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (!found[k] || !is_creep(*found[k], found, drift)) continue;
        steps[k].steady = std::max(found[k]->begin, steps[k].at_speed);
        steps[k].gap_creeps = true;
        find_periods(steps[k]);
    }
}

namespace {

/// Cell, grains and settings that all steps of one recording share.
struct Setting {
    const Recording& recording;
    const AnnularCell& cell;
    const GrainProperties& grains;
    double liquid_content;
    double least_strain;       ///< smallest strain of a steady part [1]
    double torque_resolution;  ///< [N m]
    double height_resolution;  ///< [m]
    /// Offset from the recorded times of the current step to the time since the first recording of
    /// the study began [s].
    double time_shift = 0;
};

/// Means over the steady part of a step, in SI units.
struct Means {
    Mean torque, normal_force, height, angular_velocity;
    /// Covariance of the means of (torque [N m] at the mean normal force, height [m]).
    Eigen::Matrix2d covariance;
    bool coarse = false;  ///< whether the resolution of a column limits the covariance
};

/// Smallest standard error of the mean of rounded values, in the unit of the values:
/// resolution/sqrt(12) for values on at most three rounding levels, since the values between the
/// levels are unknown; 0 for values on more levels, whose mean is more precise.
double error_from_resolution(const std::vector<double>& values, double resolution) {
    const auto [least, most] = std::ranges::minmax(values);
    const bool dithers = most - least > 2.5 * resolution;
    return dithers ? 0 : resolution / std::sqrt(12.0);
}

/// Raises the variances of mean torque and height to the limit that the columns' resolution sets.
void limit_by_resolution(Means& means, const StepSeries& steady, const Setting& setting) {
    const Eigen::Array2d least = {error_from_resolution(steady.torque, setting.torque_resolution),
                                  error_from_resolution(steady.height, setting.height_resolution)};
    for (int i = 0; i < 2; ++i) {
        if (means.covariance(i, i) >= least(i) * least(i)) continue;
        means.covariance(i, i) = least(i) * least(i);
        means.coarse = true;
    }
}

Means means_of(const StepSeries& steady) {
    Means means{mean_of_correlated(steady.torque), mean_of_correlated(steady.normal_force),
                mean_of_correlated(steady.height), mean_of_correlated(steady.angular_velocity),
                Eigen::Matrix2d::Zero()};
    std::vector<double> torque = steady.torque;  // at the mean normal force
    const double slope = means.torque.value / means.normal_force.value;
    for (std::size_t i = 0; i < torque.size(); ++i)
        torque[i] -= slope * (steady.normal_force[i] - means.normal_force.value);
    const double torque_error = mean_of_correlated(torque).standard_error;
    const double shared = covariance_of_means(torque, steady.height);
    means.covariance << torque_error * torque_error, shared, shared,
        means.height.standard_error * means.height.standard_error;
    return means;
}

/// Remark on a whole step, from which no reading is made.
Remark on_whole(const RecordedStep& step, Kind kind, const Setting& setting) {
    return {.kind = kind,
            .files = {setting.recording.file},
            .lines = {{step.series.line.front(), step.series.line.back()}},
            .step = step.number};
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Reading reading_of(const Means& means, const StepSeries& steady, int number,
                   const Setting& setting) {
    Reading reading;
    reading.origin = {setting.recording.file, steady.line.front(), 0};
    reading.last_line = steady.line.back();
    reading.step = number;
    const double height = means.height.value;
    reading.value = {shear_stress(means.torque.value, setting.cell),
                     solid_fraction(height, setting.cell)};
    reading.covariance = covariance_of_reading(height, means.covariance, setting.cell);
    reading.shear_rate = shear_rate(std::abs(means.angular_velocity.value), height, setting.cell);
    const double stress = normal_stress(means.normal_force.value, setting.cell);
    reading.condition = {stress, inertial_number(reading.shear_rate, stress, setting.grains),
                         setting.liquid_content, height};
    reading.condition.bead_volume = setting.cell.bead_volume;
    reading.condition.time = mean(steady.time) + setting.time_shift;
    reading.within_run_only = true;
    reading.sampled_seconds = steady.time.back() - steady.time.front();
    return reading;
}

/// Remark on a step of which the whole or the steady part covers a strain too small for steady
/// shear; empty if it covers enough.
std::optional<Remark> too_little_strain(const RecordedStep& step, const StepSeries& part, Kind kind,
                                        const Setting& setting) {
    Remark found = on_whole(step, kind, setting);
    found.size = strain_of(part, setting.cell);
    found.limit = setting.least_strain;
    if (found.size >= found.limit) return std::nullopt;
    found.because = {{.kind = looks_like(part)}};
    return found;
}

/// Speeds between which the speed of a step changes, if it never settles, or settles so late that
/// too few rows have one speed.
std::optional<SpeedRamp> changing_speed(const RecordedStep& step) {
    const std::span<const double> speeds = step.series.angular_velocity;
    if (const auto change = varying_speed(speeds)) return change;
    if (speeds.size() - step.at_speed >= shortest_step) return std::nullopt;
    return extreme_speeds(speeds);
}

/// Why no reading can be made of a step, as far as that is known before means are taken.
std::optional<Remark> unusable(const RecordedStep& step, const Setting& setting) {
    const StepSeries& series = step.series;
    const auto whole = [&](Kind kind) { return on_whole(step, kind, setting); };
    if (series.size() < shortest_step) {
        Remark found = whole(Kind::few_rows);
        found.count = series.size();
        return found;
    }
    if (const auto ramp = changing_speed(step)) {
        Remark found = whole(Kind::speed_ramp);
        found.size = ramp->first;
        found.size_to = ramp->last;
        return found;
    }
    if (!step.lid_turns)
        return whole(turns_back_and_forth(series.angular_velocity, series.time)
                         ? Kind::back_and_forth
                         : Kind::at_rest);
    if (auto found = too_little_strain(step, series, Kind::short_strain, setting)) return found;
    if (!step.steady) {
        Remark found = whole(Kind::never_steady);
        found.quantity = step.unsteady;
        return found;
    }
    if (series.size() - *step.steady < shortest_step) {
        Remark found = whole(Kind::few_steady_rows);
        found.count = series.size() - *step.steady;
        return found;
    }
    return too_little_strain(step, series.from(*step.steady + step.beyond_whole_turns),
                             Kind::short_steady_strain, setting);
}

/// Why the means of a step make no reading; empty if they make a reading.
std::optional<Remark> unusable(const Means& means, const RecordedStep& step,
                               const Setting& setting) {
    if (means.normal_force.value <= 0) {
        Remark found = on_whole(step, Kind::tension, setting);
        found.size = means.normal_force.value;
        return found;
    }
    if (means.torque.value <= 2 * std::sqrt(means.covariance(0, 0)))
        return on_whole(step, Kind::no_torque, setting);
    return std::nullopt;
}

/// Remarks on the rows of a step before those that are averaged.
std::vector<Remark> rows_before(const RecordedStep& step, const Setting& setting) {
    const StepSeries& series = step.series;
    const std::size_t begin = *step.steady, mean_begin = begin + step.beyond_whole_turns;
    std::vector<Remark> found;
    if (begin > 0) {
        found.push_back(on_whole(step, Kind::transient, setting));
        found.back().lines = {{series.line.front(), series.line[begin - 1]}};
        found.back().size = series.time[begin] - series.time.front();
    }
    if (mean_begin > begin) {
        found.push_back(on_whole(step, Kind::part_of_turn, setting));
        found.back().lines = {{series.line[begin], series.line[mean_begin - 1]}};
    }
    return found;
}

/// Standard error [1] of a solid fraction that is not known: about the distance from random loose
/// to random close packing, 0.55 to 0.64, so that it determines nothing.
constexpr double unknown_fraction_error = 0.1;

/// Marks a reading whose gap creeps, by `creep` over the steady part. The fraction at the mean gap
/// stays as its value.
void doubt_fraction(Reading& reading, double creep, const StepSeries& steady,
                    const Setting& setting) {
    const double strain = strain_of(steady, setting.cell);
    reading.condition.gap_creep = creep / strain;
    reading.covariance(0, 1) = reading.covariance(1, 0) = 0;
    reading.covariance(1, 1) = unknown_fraction_error * unknown_fraction_error;
}

/// Adds the reading of one step to `result`, or a remark on why there is none. Adds the number of
/// the step to `coarse` if the resolution of a column limits the reading's error.
void reduce_step(const RecordedStep& step, const Setting& setting, std::vector<int>& coarse,
                 Measurements& result) {
    if (auto why = unusable(step, setting)) return result.remarks.push_back(*std::move(why));
    const StepSeries steady = step.series.from(*step.steady + step.beyond_whole_turns);
    Means means = means_of(steady);
    limit_by_resolution(means, steady, setting);
    if (auto why = unusable(means, step, setting)) return result.remarks.push_back(*std::move(why));
    append(result.remarks, rows_before(step, setting));
    if (means.coarse) coarse.push_back(step.number);
    result.readings.push_back(reading_of(means, steady, step.number, setting));
    if (step.gap_creeps)
        doubt_fraction(result.readings.back(), creep_of(step.series)->change, steady, setting);
}

/// Remarks on rows with spikes in torque, normal force, gap or speed. Before the steady part, a
/// fast rise may look like one, and nothing is averaged.
std::vector<Remark> spikes_of(const RecordedStep& step, const std::string& file) {
    std::vector<Remark> found;
    for (const std::size_t k : step.spikes) {
        if (k < step.steady.value_or(0)) continue;
        const int line = step.series.line[k];
        found.push_back({.kind = Kind::spike, .files = {file}, .lines = {{line, line}}});
    }
    return found;
}

/// Adds a note on these steps of a file, if there are any.
void note_steps(const std::vector<int>& steps, Remark note, Measurements& result) {
    if (steps.empty()) return;
    for (const int step : steps)
        note.names.push_back(std::to_string(step));
    result.remarks.push_back(std::move(note));
}

}  // namespace

Measurements reduce_steps(const std::vector<RecordedStep>& steps, const Recording& recording,
                          const AnnularCell& cell, const GrainProperties& grains,
                          double liquid_content, RunClock& clock, const ImportSettings& choice) {
    Setting setting{recording,
                    cell,
                    grains,
                    liquid_content,
                    choice.least_strain,
                    least_step(recording.torque),
                    least_step(recording.height)};
    Measurements result;
    std::vector<int> flipped, interpolated, coarse, spiked;
    for (const RecordedStep& step : steps) {
        const std::vector<Remark> spikes = spikes_of(step, recording.file);
        if (!spikes.empty()) spiked.push_back(step.number);
        append(result.remarks, spikes);
        if (step.series.flipped) flipped.push_back(step.number);
        if (step.series.interpolated) interpolated.push_back(step.number);
        setting.time_shift =
            clock.shift(recording.time[step.rows.begin], recording.time[step.rows.end - 1]);
        reduce_step(step, setting, coarse, result);
    }
    const auto note = [&](Kind kind) { return Remark{.kind = kind, .files = {recording.file}}; };
    note_steps(spiked, note(Kind::steps_with_spikes), result);
    note_steps(flipped, note(Kind::flipped_torques), result);
    note_steps(interpolated, note(Kind::interpolated_steps), result);
    Remark resolution = note(Kind::coarse_steps);
    resolution.size = setting.torque_resolution;
    resolution.size_to = setting.height_resolution;
    note_steps(coarse, std::move(resolution), result);
    if (!recording.unused_columns.empty()) {
        Remark& unused = result.remarks.emplace_back(note(Kind::unused_columns));
        unused.names = recording.unused_columns;
    }
    result.remarks = decide(std::move(result.remarks), choice.keep_implausible);
    return result;
}

}  // namespace pendular
