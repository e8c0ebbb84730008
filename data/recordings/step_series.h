#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/recordings/recording.h"
#include "data/recordings/time_series.h"

namespace pendular {

/// One step of a recording as evenly spaced series, in SI units.
struct StepSeries {
    std::vector<double> time;
    std::vector<double> torque;
    std::vector<double> normal_force;
    std::vector<double> height;
    std::vector<double> angular_velocity;
    std::vector<int> line;      ///< of the file, of the row at or before each sample
    bool interpolated = false;  ///< whether the rows were not evenly spaced
    bool flipped = false;       ///< whether the torque was negative

    std::size_t size() const { return time.size(); }
    /// Series of the samples from `begin` on.
    StepSeries from(std::size_t begin) const;
};

/// Converts the rows of a step to a series. Times are interpolated linearly to even spacing where a
/// spacing is less than half or more than one and a half times the usual one. A wholly negative
/// torque is flipped.
/// @throws InputError at the first row whose torque has the rarer sign, if both signs are more than
///         noise around zero while the lid turns
StepSeries step_series(const Recording& recording, const Step& step);

/// Whether the lid turns: its mean angular velocity [rad/s] is not zero within 3 standard errors.
bool turns(const Mean& angular_velocity);

/// Number of leading samples to leave out until torque and gap are both steady, the later of the
/// two. A series that changes by less than 0.1 % over the last half of a step is steady there.
/// Empty with the reason in `why` where one never becomes steady.
std::optional<std::size_t> end_of_transient(const StepSeries& series, std::string& why);

}  // namespace pendular
