#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/recording.h"
#include "data/recordings/time_series.h"

namespace pendular {

/// One step of a recording as series that are evenly spaced in time.
struct StepSeries {
    std::vector<double> time;              ///< time on the recording's clock [s]
    std::vector<double> torque;            ///< torque on the lid [N m]
    std::vector<double> normal_force;      ///< normal force on the lid [N]
    std::vector<double> height;            ///< gap, the height of the sample [m]
    std::vector<double> angular_velocity;  ///< angular velocity of the lid [rad/s]
    std::vector<int> line;                 ///< line of the row at or before each sample in the file
    bool interpolated = false;             ///< whether unevenly spaced rows were interpolated
    bool flipped = false;                  ///< whether the sign of a negative torque was changed

    std::size_t size() const { return time.size(); }
    /// Returns the series without the samples before index `begin`.
    StepSeries from(std::size_t begin) const;
};

/// Converts the rows of a step to evenly spaced series. All columns are interpolated linearly if a
/// spacing in time is less than 0.5 or more than 1.5 times the median spacing. If the lid turns and
/// the torque is mostly negative, its sign is changed.
/// @throws InputError at the first row whose torque has the rarer sign, if the lid turns and the
///         torque has both signs by more than noise around zero
StepSeries step_series(const Recording& recording, const Step& step);

/// Whether the lid turns: its mean angular velocity [rad/s] differs from 0 by more than 3 standard
/// errors of this mean.
bool turns(const Mean& angular_velocity);

/// Number of leading samples before torque and gap are both steady; empty, with the reason in
/// `why`, if one of them never becomes steady. The last half of a series counts as steady if its
/// last two quarters differ by less than 0.1 %.
std::optional<std::size_t> end_of_transient(const StepSeries& series, std::string& why);

}  // namespace pendular
