#include "data/recordings/steady_state.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "data/recordings/robust.h"
#include "data/recordings/speed_ramp.h"
#include "data/recordings/step_series.h"
#include "data/recordings/time_series.h"
#include "data/recordings/unsteady.h"

namespace pendular {
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

/// Why a step gives no reading: in its own words, and as far as other steps share it.
struct Reason {
    std::string text;
    Excluded::Cause cause;
};

/// Reason why the means of a step make no reading; empty if they make a reading.
std::optional<Reason> unusable(const Means& means) {
    if (means.normal_force.value <= 0)
        return Reason{fmt::format("the mean normal force is {:.3g} N, no compression; compression "
                                  "must be positive: reverse the sign of the column of the normal "
                                  "force if compression was recorded as negative",
                                  means.normal_force.value),
                      {"the normal force is negative",
                       "compression must be positive: reverse the sign of the column of the "
                       "normal force in the recordings"}};
    if (means.torque.value <= 2 * std::sqrt(means.covariance(0, 0)))
        return Reason{"the mean torque is zero within twice its standard error",
                      {"the torque is zero within its error",
                       "check that the torque was recorded, and its unit"}};
    return std::nullopt;
}

/// Reason why a lid whose mean speed is not known to differ from zero gives no steady shear.
Reason no_steady_turn(const StepSeries& series) {
    // Path of the lid [rad], in both directions, from which on it is not at rest: a tenth of a turn.
    constexpr double back_and_forth = 0.6;
    double angle = 0;
    for (std::size_t i = 1; i < series.size(); ++i)
        angle += std::abs(series.angular_velocity[i]) * (series.time[i] - series.time[i - 1]);
    // Slow reversals spread far beyond the noise from row to row; noise about zero does not.
    const double noise = sample_noise(series.angular_velocity);
    const double usual = robust_deviation(series.angular_velocity);
    if (angle > back_and_forth && usual > 3 * noise)
        return {"the lid turns back and forth: no steady shear",
                {"the lid turns back and forth", "export steps of constant speed"}};
    return {"the lid does not turn: rest or consolidation",
            {"the lid does not turn", "check the column of the angular velocity, and its unit"}};
}

Reason ramped(const SpeedRamp& ramp) {
    return {fmt::format("the speed of the lid changes {} within the step, from {:.3g} to {:.3g} "
                        "rad/s: no steady shear; export steps of constant speed",
                        ramp.change(), ramp.first, ramp.last),
            {"the speed of the lid changes", "no steady shear: export steps of constant speed"}};
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

/// Reason to exclude a step or its steady part (`what`) whose strain [1] is too small for steady
/// shear.
std::string short_strain(const char* what, double strain, const StepSeries& series,
                         const Setting& setting) {
    return fmt::format(
        "{} covers a strain of {:.2g}, steady shear takes {:g} (least_strain in [import]); it "
        "looks like {}, unless the angular velocity is in another unit",
        what, strain, setting.least_strain, looks_like(series));
}

/// Adds the reading of one step to `result`, or the step with the reason to `result.excluded`. Adds
/// the number of the step to `coarse` if the resolution of a column limits the reading's error.
void reduce_step(const RecordedStep& step, const Setting& setting, std::vector<int>& coarse,
                 Measurements& result) {
    const StepSeries& series = step.series;
    const int number = step.number;
    const auto exclude = [&](std::size_t end, const std::string& reason, Excluded::Cause cause,
                             Excluded::Kind kind = Excluded::Kind::rows) {
        result.excluded.push_back({{setting.recording.file, series.line.front(), 0},
                                   series.line[end - 1],
                                   fmt::format("step {}: {}", number, reason),
                                   kind,
                                   std::move(cause)});
    };
    const Excluded::Cause short_cause = {
        "the strain is too small for steady shear",
        fmt::format("steady shear takes a strain of {:g} (least_strain in [import]): check the "
                    "unit of the angular velocity, or record longer",
                    setting.least_strain)};
    constexpr auto no_plateau = Excluded::Kind::step_without_plateau;
    if (series.size() < shortest_step)
        return exclude(series.size(),
                       fmt::format("has {} rows, {} are needed", series.size(), shortest_step),
                       {fmt::format("less than {} rows were recorded", shortest_step), ""});
    if (const auto ramp = speed_ramp(series.angular_velocity)) {
        const Reason reason = ramped(*ramp);
        return exclude(series.size(), reason.text, reason.cause);
    }
    if (!step.lid_turns) {
        const Reason reason = no_steady_turn(series);
        return exclude(series.size(), reason.text, reason.cause);
    }
    if (const double strain = strain_of(series, setting.cell); strain < setting.least_strain)
        return exclude(series.size(), short_strain("it", strain, series, setting), short_cause);
    const auto begin = step.steady;
    if (!begin)
        return exclude(series.size(), step.why_unsteady,
                       {"torque or gap still change at the end", "record longer"}, no_plateau);
    if (series.size() - *begin < shortest_step)
        return exclude(
            series.size(),
            fmt::format("{} rows are steady, {} are needed", series.size() - *begin, shortest_step),
            {fmt::format("less than {} rows are steady", shortest_step), "record longer"},
            no_plateau);
    const StepSeries level = series.from(*begin);
    const StepSeries steady = level.from(step.beyond_whole_turns);
    if (const double strain = strain_of(steady, setting.cell); strain < setting.least_strain)
        return exclude(series.size(), short_strain("its steady part", strain, steady, setting),
                       short_cause, no_plateau);
    Means means = means_of(steady);
    limit_by_resolution(means, steady, setting);
    if (const auto reason = unusable(means))
        return exclude(series.size(), reason->text, reason->cause, Excluded::Kind::reading);
    if (*begin > 0)
        exclude(*begin,
                fmt::format("transient of {:.3g} s, until torque and gap are steady",
                            series.time[*begin] - series.time.front()),
                {}, Excluded::Kind::beside_plateau);
    if (steady.size() < level.size())
        result.excluded.push_back(
            {{setting.recording.file, level.line.front(), 0},
             level.line[level.size() - steady.size() - 1],
             fmt::format("step {}: part of a turn of the lid, whose wobble would bias the mean",
                         number),
             Excluded::Kind::beside_plateau});
    if (means.coarse) coarse.push_back(number);
    result.readings.push_back(reading_of(means, steady, number, setting));
}

/// Adds rows with spikes in torque, normal force or gap to `result.excluded`.
void exclude_spikes(const StepSeries& series, const std::vector<std::size_t>& rows,
                    const std::string& file, Measurements& result) {
    for (const std::size_t k : rows) {
        result.excluded.push_back({{file, series.line[k], 0},
                                   series.line[k],
                                   "spike: torque, force or gap is far off the rows around it"});
    }
}

/// Adds a note on these steps of a file, if there are any.
void note_steps(const std::vector<int>& steps, const std::string& file, const std::string& what,
                Measurements& result) {
    if (steps.empty()) return;
    result.notes.push_back(fmt::format("{}: step {}: {}", file, fmt::join(steps, ", "), what));
}

}  // namespace

Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content) {
    RunClock first;
    return reduce_recording(recording, cell, grains, liquid_content, first);
}

Measurements reduce_recording(const Recording& recording, const AnnularCell& cell,
                              const GrainProperties& grains, double liquid_content, RunClock& clock,
                              const ImportSettings& choice) {
    return reduce_steps(recorded_steps(recording), recording, cell, grains, liquid_content, clock,
                        choice);
}

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
        if (!step.spikes.empty()) {
            spiked.push_back(step.number);
            exclude_spikes(step.series, step.spikes, recording.file, result);
        }
        if (step.series.flipped) flipped.push_back(step.number);
        if (step.series.interpolated) interpolated.push_back(step.number);
        setting.time_shift =
            clock.shift(recording.time[step.rows.begin], recording.time[step.rows.end - 1]);
        reduce_step(step, setting, coarse, result);
    }
    note_steps(spiked, recording.file,
               "single rows jump far off their neighbours and back; they were left out (listed in "
               "excluded.csv). Look for a disturbance, or a wrong column",
               result);
    note_steps(flipped, recording.file, "the torque was negative; its sign was flipped", result);
    note_steps(interpolated, recording.file,
               "samples are unevenly spaced in time; interpolated to even spacing", result);
    note_steps(coarse, recording.file,
               fmt::format("torque or gap hardly changes from row to row: their standard errors "
                           "are set to their resolution, {:.3g} mN m and {:.3g} mm",
                           1e3 * setting.torque_resolution, 1e3 * setting.height_resolution),
               result);
    if (!recording.unused_columns.empty())
        result.notes.push_back(fmt::format("{}: columns not used: '{}'", recording.file,
                                           fmt::join(recording.unused_columns, "', '")));
    return result;
}

}  // namespace pendular
