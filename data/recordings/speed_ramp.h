#pragma once

#include <optional>
#include <span>
#include <string>

namespace pendular {

/// Speeds at the beginning and end of a step in which the speed never settles, in their unit.
struct SpeedRamp {
    double first = 0;
    double last = 0;
    /// Returns the larger over the smaller speed [1]; infinite if the smaller is 0.
    double factor() const;
    /// Returns "by a factor of 200", or "from or to rest".
    std::string change() const;
};

/// Returns the speeds between which the speed of a step changes, if it still changes by more than
/// 20 % over the second half of the step; empty for a lid that turns steadily, rests, or has
/// settled after a transient. Steps of less than `shortest_step` rows are not judged.
/// @param speeds angular velocity or shear rate of each row of the step
std::optional<SpeedRamp> speed_ramp(std::span<const double> speeds);

}  // namespace pendular
