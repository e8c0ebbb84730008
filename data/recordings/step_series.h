#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/recording.h"
#include "data/recordings/time_series.h"

namespace pendular {

/// Samples of one step of a recording, evenly spaced in time.
struct StepSeries {
    std::vector<double> time;              ///< time of each sample on the recording's clock [s]
    std::vector<double> torque;            ///< torque on the lid at each sample [N m]
    std::vector<double> normal_force;      ///< normal force on the lid at each sample [N]
    std::vector<double> height;            ///< gap (height of the sample) at each time [m]
    std::vector<double> angular_velocity;  ///< angular velocity of the lid at each sample [rad/s]
    std::vector<int> line;                 ///< line in the file of the row at or before each sample
    /// True if the rows were unevenly spaced in time and were interpolated.
    bool interpolated = false;
    bool flipped = false;  ///< true if the torque was mostly negative and its sign was changed

    std::size_t size() const { return time.size(); }
    /// Returns the series without the samples before index `begin`, which counts from 0.
    StepSeries from(std::size_t begin) const;
};

/// Converts the rows of a step to evenly spaced samples. All columns are interpolated linearly if
/// any two neighbouring times are less than 0.5 or more than 1.5 times the median spacing apart. If
/// the lid turns and the torque is mostly negative, the sign of the torque is changed.
/// @throws InputError if the lid turns and the torque is positive in some rows and negative in
///         others by more than noise; the position is the first row whose torque has the rarer sign
StepSeries step_series(const Recording& recording, const Step& step);

/// Whether the lid turns: its mean angular velocity differs from 0 by more than 3 standard errors.
/// @param angular_velocity mean angular velocity with its standard error [rad/s]
bool turns(const Mean& angular_velocity);

/// Number of samples at the beginning of a step that are not steady in torque or gap. Empty if
/// torque or gap never becomes steady; `why` is then set to the reason. A series whose last two
/// quarters differ by less than 0.1 % counts as steady in its second half.
std::optional<std::size_t> end_of_transient(const StepSeries& series, std::string& why);

}  // namespace pendular
