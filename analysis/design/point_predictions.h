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
/// point after point: shear stress [Pa] and solid fraction [1] of a reading, or the one value of a
/// direct measurement. Also returns the derivatives of the values with respect to the parameters,
/// and the covariance of the values from errors of the simulation.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Returns the variance of the measurement error of each value, in its squared unit: for each
/// point, of shear stress and solid fraction, or of the one value of a direct measurement.
/// @param shown expected values of the measurements, in the same order
/// @param relative_noise relative standard errors of the shear stress and the solid fraction of one
///        reading, in this order [1]; direct measurements have their own standard errors instead
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
