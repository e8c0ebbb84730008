#pragma once

#include <optional>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Set points of the lid of an annular rheometer.
struct SetPoint {
    double normal_force = 0;      ///< [N]
    double angular_velocity = 0;  ///< [rad/s]
};

/// Returns the set points that impose the normal stress and the inertial number of a condition;
/// empty if the study states no cell. The sample height is computed from a typical solid fraction
/// of 0.6, so that the angular velocity is right within a few per cent.
std::optional<SetPoint> set_point_of(const Condition& condition, const Study& study);

}  // namespace pendular
