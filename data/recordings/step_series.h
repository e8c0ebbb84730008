#pragma once

#include <optional>
#include <string>
#include <vector>

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
/// than 0.5 or more than 1.5 times the median spacing apart, all columns are interpolated linearly.
/// If the lid turns and the torque is mostly negative, its sign is changed.
/// @throws InputError at the first row whose torque has the rarer sign, if the lid turns and the
///         torque has both signs by more than noise
StepSeries step_series(const Recording& recording, const Step& step);

/// Whether the lid turns: the mean angular velocity differs from 0 by more than 3 standard errors.
bool turns(const Mean& angular_velocity);

/// Returns the number of data points at the beginning of a step that are not steady in torque or
/// gap; if one never becomes steady, empty, with its name in `unsteady`, which is empty for both. A
/// torque or gap without a
/// steady part still counts as steady in the second half of the step if its means over the last two
/// quarters differ by less than 0.1 %.
std::optional<std::size_t> end_of_transient(const StepSeries& series, std::string& unsteady);

}  // namespace pendular
