#pragma once

#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Number of values that a reading at a point gives: two for shear, one for a direct measurement.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Prediction of a rival at several points: the entries of the points in turn, with the covariance
/// from simulation.
Prediction predicted_at(const Rival& rival, const std::vector<Point>& points);

/// Variances of one reading at each of some points, where this is what they would show: readings of
/// shear scatter by `relative_noise`, direct measurements by their own errors.
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

}  // namespace pendular
