#pragma once

#include <optional>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Set points of an annular rheometer: normal force and angular velocity that the user sets to
/// shear the grains at a given normal stress and inertial number.
struct SetPoint {
    double normal_force = 0;      ///< normal force on the lid [N]
    double angular_velocity = 0;  ///< angular velocity of the lid [rad/s]
};

/// Returns the set points of the rheometer that impose the normal stress and the inertial number of
/// a condition. The result is empty if the study states no cell. The height of the sample is
/// computed from a typical solid fraction of 0.6, so that the angular velocity is right within a
/// few per cent.
std::optional<SetPoint> set_point_of(const Condition& condition, const Study& study);

}  // namespace pendular
