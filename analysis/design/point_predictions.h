#pragma once

#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Returns the number of values that a measurement at a point (possible measurement) gives: two for
/// a reading of steady shear (shear stress and solid fraction), one for a direct measurement of an
/// effect's parameter.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Returns the values that a rival model with its fitted parameters predicts at several points
/// (possible measurements), in the order of the points. A reading has two values: shear stress [Pa]
/// and solid fraction [1]. A direct measurement of an effect's parameter has one value [unit of the
/// parameter]. The result contains the derivatives of the values with respect to the parameters and
/// the covariance of the simulation's errors.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Returns the variances of the measurement errors at several points (possible measurements), in
/// the squared units of the measured values and in the order of the points. A reading has two
/// values: shear stress and solid fraction. A direct measurement of an effect's parameter has one
/// value.
/// @param shown expected measured values, in the order of the returned variances
/// @param relative_noise relative standard errors [1] of the shear stress (first) and of the solid
///        fraction (second) of one reading; not used for direct measurements, which state their
///        standard errors
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
