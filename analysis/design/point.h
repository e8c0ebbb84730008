#pragma once

#include <optional>
#include <vector>

#include "calib/fit/fitted_model.h"

namespace pendular {

/// Possible next measurement: a reading of steady shear at one condition, or a direct measurement.
/// Costs are in units of the cost of one dry reading.
struct Point {
    Condition condition = {};                      ///< unused if `direct` has a value
    std::optional<DirectMeasurement> direct = {};  ///< empty for a reading
    /// Cost of refilling the cell before the first reading; 0 with the beads that are in the cell.
    double first_cost = 0;
    double wait = 0;       ///< time between the study's last reading and this one [s]
    double wait_cost = 0;  ///< cost of `wait`
    double cost = 1;       ///< cost of each reading
};

/// Prediction of a rival for one measurement at one point.
struct Forecast {
    /// Shear stress [Pa] and solid fraction [1], or the parameter [its unit] of a direct
    /// measurement.
    Eigen::VectorXd value;
    Eigen::MatrixXd from_parameters;  ///< covariance by errors of the fitted parameters
    Eigen::MatrixXd from_simulation;  ///< covariance by errors of the model
};

/// Returns the number of values that a measurement at a point gives.
inline Eigen::Index entries_at(const Point& point) {
    return point.direct ? 1 : 2;
}

/// Returns what a rival with its fitted parameters predicts at the points, in their order: shear
/// stress [Pa] and solid fraction [1] of a reading, or the parameter [its unit] of a direct
/// measurement. The covariance is that of the model's errors; 0 for direct measurements.
Prediction predicted_at(const FittedModel& rival, const std::vector<Point>& points);

/// Returns the variances of the errors of measurement [squared unit of each value], in the order of
/// `predicted_at`.
/// @param shown expected measured values
/// @param relative_noise relative standard errors [1] of shear stress and solid fraction of a
///        reading; direct measurements state their own
Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise);

/// Smallest noncentrality [1] at which a chi2 test at 5 % significance has a power of 0.8: with the
/// two degrees of freedom of a reading, also used for readings at several points together, and with
/// the one of a direct measurement.
inline constexpr double telling_noncentrality = 9.63, telling_directly = 7.85;

}  // namespace pendular
