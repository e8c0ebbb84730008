#pragma once

#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Number of values that a measurement at a point gives: two for steady shear (shear stress, solid
/// fraction), one for a direct measurement.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Values that a rival model predicts at several points with its fitted parameters, point after
/// point (`entries_at` values each), with their derivatives by these parameters and their
/// covariance from errors of the simulation.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Variance of the error of each value in one measurement at each point [unit of the value
/// squared], in the order of `predicted_at`.
/// @param shown expected values of the measurements, in the order of `predicted_at`
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]; direct measurements have their own standard errors instead
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
