#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/recordings/recording.h"
#include "data/recordings/time_series.h"

namespace pendular {

/// Data points of one step of a recording, evenly spaced in time. `line` is that of the row at or
/// before each data point.
struct StepSeries : IntervalSeries {
    bool interpolated = false;  ///< whether rows were unevenly spaced in time
    bool flipped = false;       ///< whether the torque was mostly negative, and changed its sign

    /// Returns the series without the data points before index `begin`.
    StepSeries from(std::size_t begin) const {
        return {rows(begin, size()), interpolated, flipped};
    }
};

/// Returns the rows of a step as evenly spaced data points. If any two neighbouring times are less
/// than 0.5 or more than 1.5 times the median spacing apart, torque, force, gap and speed are
/// interpolated linearly, and columns that the instrument computed are dropped.
/// If the lid turns and the torque is mostly negative, its sign is changed.
/// @throws InputError at the first row whose torque has the rarer sign, if the lid turns and the
///         torque has both signs by more than noise
StepSeries step_series(const Recording& recording, const Step& step);

/// Returns the number of data points at the beginning of a step that are not steady in torque or
/// gap; if one never becomes steady, empty, with its name in `unsteady`, which is empty for both. A
/// torque or gap without a steady part still counts as steady in the second half of the step if its
/// means over the last two quarters differ by less than 0.1 %.
std::optional<std::size_t> end_of_transient(const StepSeries& series, std::string& unsteady);

/// Change of the gap in the part of a step whose torque is steady.
struct Creep {
    std::size_t begin = 0;  ///< data points before the part
    /// Change from the first to the last data point of the part over the mean [1], by a straight
    /// line through the means of the first and the last quarter.
    double change = 0;
    double error = 0;  ///< standard error of `change` [1]
};

/// Returns the creep of a step; empty if the torque is not steady, or the gap changes by more than
/// `most_creep`, as in consolidation.
std::optional<Creep> creep_of(const StepSeries& series);

/// Largest `Creep::change` [1] at which the torque counts as that of steady shear. A bed that is
/// sheared only under its lid compacts by less: 1 % of a bed of 12 diameters over a strain of 8,
/// with the shear in its upper half (bench/real_cell). Twice this allows for more; a filling that
/// consolidates, from random loose to close packing, changes by 15 %.
constexpr double most_creep = 0.02;

/// Speeds at the beginning and end of a step in which the speed never settles, in their unit; the
/// least and the greatest where the step ends with the speed with which it begins.
struct SpeedRamp {
    double first = 0;
    double last = 0;
    /// Returns the larger over the smaller speed [1]; infinite if the smaller is 0.
    double factor() const;
    /// Returns "by a factor of 200", or "from or to rest".
    std::string change() const;
};

/// Returns the least and the greatest speed of a step, two values that may be spikes aside.
SpeedRamp extreme_speeds(std::span<const double> speeds);

/// Returns the speeds between which the speed of a step changes, if it still changes by more than
/// 20 % over the second half of the step; empty for a lid that turns steadily, rests, or has
/// settled after a transient. Steps of less than `shortest_step` rows are not judged.
/// @param speeds angular velocity or shear rate of each row of the step
std::optional<SpeedRamp> speed_ramp(std::span<const double> speeds);

/// Returns the speeds between which the lid keeps changing its speed: those of `speed_ramp`, or
/// the extremes of slow waves of more than 20 % about their mean, from the first row at speed on;
/// empty for a lid that turns steadily.
/// @param angular_velocity of each row of the step [rad/s]
std::optional<SpeedRamp> varying_speed(std::span<const double> angular_velocity);

/// Replaces each spike in torque, normal force, height and angular velocity by the median of the 11
/// values around it (`replace_spikes`). Returns the indices of the data points that changed, in
/// ascending order.
std::vector<std::size_t> take_out_spikes(StepSeries& series);

/// Returns the shear strain [1] of a step: magnitude of the mean shear rate times the duration.
double strain_of(const StepSeries& series, const AnnularCell& cell);

/// Returns what a step that is too short for steady shear looks like:
/// - unloading or loading: the normal force changes by more than 20 %
/// - consolidation: the gap shrinks by more than 1 %
/// - shear to failure: the torque peaks and drops
/// - shear that was stopped while the torque rose
/// - preshear: the torque levels off
Remark::Kind looks_like(const StepSeries& series);

}  // namespace pendular
