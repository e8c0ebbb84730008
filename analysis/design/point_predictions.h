#pragma once

#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Number of values that a measurement at a point gives: two for steady shear (shear stress, solid
/// fraction), one for a direct measurement.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Returns the values that a rival model predicts with its fitted parameters at several points,
/// point after point: shear stress [Pa] and solid fraction [1] of a reading, one value of a direct
/// measurement. Also returns the derivatives of the values with respect to the parameters, and the
/// covariance of the values from errors of the simulation.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Returns the variance of the measurement error of each value, in its squared unit, point after
/// point as in `predicted_at`.
/// @param shown expected values of the measurements, point after point
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]; direct measurements have their own standard errors instead
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
