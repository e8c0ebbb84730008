#pragma once

#include <memory>
#include <optional>
#include <string>

#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Model that may be the right one, with its fitted parameters and their covariance.
struct Rival {
    std::string name;
    std::shared_ptr<const Predictor> model;
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance;
};

/// A point that could be measured, and what a reading there costs; or a direct measurement that
/// could be made, which is a reading of one number.
struct Point {
    Condition condition = {};
    std::optional<DirectMeasurement> direct = {};  ///< the direct measurement, if the point is one
    double first_cost = 0;  ///< cost of the filling, before its first reading
    double wait = 0;        ///< waiting time after the last reading [s]
    double wait_cost = 0;   ///< cost of the waiting time
    double cost = 1;        ///< cost of each reading
};

/// Forecast of a rival at one point: (shear stress [Pa], solid fraction [1]), or the one number of
/// a direct measurement [its unit].
struct Forecast {
    Eigen::VectorXd value;
    Eigen::MatrixXd from_parameters;  ///< covariance from errors of the rival's parameters
    Eigen::MatrixXd from_simulation;  ///< covariance from errors of the simulation
};

/// Noncentrality at which rivals are told apart in 4 of 5 cases at 5 %: of two observables, which
/// counts for several points together too, and of the one of a direct measurement.
inline constexpr double telling_noncentrality = 9.63, telling_directly = 7.85;

}  // namespace pendular
