#pragma once

#include <memory>
#include <optional>
#include <string>

#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// A model that may be the right one, with what its fit says of its parameters.
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
    std::optional<DirectMeasurement> direct = {};  ///< if it is one
    double first_cost = 0;                         ///< before the first reading of this filling
    double wait = 0;                               ///< before it, from the last reading on [s]
    double wait_cost = 0;                          ///< of that; shorter ones are over by then
    double cost = 1;                               ///< of each reading
};

/// Forecast of a rival at one point: (shear stress [Pa], solid fraction [1]), or the one number of
/// a direct measurement [its unit].
struct Forecast {
    Eigen::VectorXd value;
    Eigen::MatrixXd from_parameters;  ///< covariance by errors of its parameters
    Eigen::MatrixXd from_simulation;  ///< by those of the simulation
};

/// Noncentrality at which rivals are told apart in 4 of 5 cases at 5 %: of two observables, which
/// counts for several points together too, and of the one of a direct measurement.
inline constexpr double telling_noncentrality = 9.63, telling_directly = 7.85;

}  // namespace pendular
