#pragma once

#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Returns the number of values that a measurement at a point gives: two for a reading of steady
/// shear (shear stress and solid fraction), one for a direct measurement.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Returns the values that a rival model predicts with its fitted parameters at several points,
/// point after point. A reading has two values, first the shear stress [Pa] and second the solid
/// fraction [1]. A direct measurement has one value [its unit]. The result also contains the
/// derivatives of the values with respect to the parameters, and the covariance of the errors of
/// the values that come from the simulation.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Returns the variance of the measurement error of each value, in the squared unit of the value,
/// point after point. A reading has two values, first the shear stress and second the solid
/// fraction. A direct measurement has one value.
/// @param shown expected values of the measurements, in the order of the returned variances
/// @param relative_noise relative standard errors of one reading [1]: first that of the shear
///        stress, second that of the solid fraction; direct measurements have their own standard
///        errors instead
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
