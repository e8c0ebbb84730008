#pragma once

#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Number of values that a measurement at a point gives: two for steady shear (shear stress, solid
/// fraction), one for a direct measurement.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Values that a rival model predicts at several points, point after point, with their derivatives
/// and their covariance from simulation. A point has `entries_at` values.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Variance of each value in one reading at each point, in the order of `predicted_at`.
/// @param shown values that the readings would show
/// @param relative_noise standard errors of (shear stress, solid fraction) over their values [1];
///        direct measurements have their own standard errors instead
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
