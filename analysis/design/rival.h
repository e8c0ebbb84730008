#pragma once

#include <memory>
#include <optional>
#include <string>

#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Name of the rival that is the study's model itself.
inline constexpr const char* present_model = "the model as it is";

/// One of several fitted models of a study that measurements are to tell apart.
struct Rival {
    /// Effects added to the study's model, joined by " + ", after a number such as "proposal 1: "
    /// if Pendular proposed them; `present_model` without any.
    std::string name;
    std::shared_ptr<const Predictor> model;
    Eigen::VectorXd parameters;  ///< fitted, in the order and units of `model->parameters()`
    Eigen::MatrixXd covariance;  ///< of the errors of `parameters`
    double chi2 = 0;             ///< of all readings and direct measurements [1]
};

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
    Eigen::MatrixXd from_simulation;  ///< covariance by errors of the simulation
};

/// Smallest noncentrality [1] at which a chi2 test at 5 % significance has a power of 0.8: with the
/// two degrees of freedom of a reading, also used for readings at several points together, and with
/// the one of a direct measurement.
inline constexpr double telling_noncentrality = 9.63, telling_directly = 7.85;

}  // namespace pendular
