#pragma once

#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Returns the number of values that a measurement at a point gives.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Returns what a rival with its fitted parameters predicts at the points, in their order: shear
/// stress [Pa] and solid fraction [1] of a reading, or the parameter [its unit] of a direct
/// measurement. The covariance is that of the simulation's errors.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Returns the variances of the errors of measurement [squared unit of each value], in the order of
/// `predicted_at`.
/// @param shown expected measured values
/// @param relative_noise relative standard errors [1] of shear stress and solid fraction of a
///        reading; direct measurements state their own
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
