#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/recording.h"
#include "data/recordings/time_series.h"

namespace pendular {

/// Data points of one step of a recording, evenly spaced in time.
struct StepSeries {
    std::vector<double> time;          ///< time of each data point on the recording's clock [s]
    std::vector<double> torque;        ///< torque on the lid at each data point [N m]
    std::vector<double> normal_force;  ///< normal force on the lid at each data point [N]
    std::vector<double> height;        ///< gap (height of the sample) at each data point [m]
    /// Angular velocity of the lid at each data point [rad/s].
    std::vector<double> angular_velocity;
    std::vector<int> line;  ///< line in the file of the row at or before each data point
    /// Whether the rows were unevenly spaced in time and were interpolated.
    bool interpolated = false;
    bool flipped = false;  ///< whether the torque was mostly negative and its sign was changed

    std::size_t size() const { return time.size(); }
    /// Returns the series without the data points before index `begin`, which is counted from 0.
    StepSeries from(std::size_t begin) const;
};

/// Converts the rows of a step to evenly spaced data points. If any two neighbouring times are less
/// than 0.5 or more than 1.5 times the median spacing apart, all columns are interpolated linearly.
/// If the lid turns and the torque is mostly negative, the sign of the torque is changed.
/// @throws InputError at the first row whose torque has the rarer sign, if the lid turns and the
///         torque has both signs by more than noise
StepSeries step_series(const Recording& recording, const Step& step);

/// Whether the lid turns: the mean angular velocity differs from 0 by more than 3 standard errors.
/// @param angular_velocity mean angular velocity with its standard error [rad/s]
bool turns(const Mean& angular_velocity);

/// Returns the number of data points at the beginning of a step that are not steady in torque or
/// gap. If torque or gap never becomes steady, the result is empty and `why` is set to the reason.
/// A torque or gap without a steady part still counts as steady in the second half of the step if
/// its means over the last two quarters differ by less than 0.1 %.
std::optional<std::size_t> end_of_transient(const StepSeries& series, std::string& why);

}  // namespace pendular
