#pragma once

#include <memory>
#include <optional>
#include <string>

#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// One of several models that fit a study's readings, with its fitted parameters.
struct Rival {
    std::string name;  ///< effects added to the study's model, or "the model as it is"
    std::shared_ptr<const Predictor> model;
    Eigen::VectorXd parameters;  ///< fitted parameters, in the order of `model->parameters()`
    Eigen::MatrixXd covariance;  ///< covariance of `parameters`
};

/// Possible next measurement with its cost: a reading of steady shear at a condition, or a direct
/// measurement of one parameter. Costs are in units of one dry reading.
struct Point {
    Condition condition = {};  ///< condition of the reading; unused by a direct measurement
    std::optional<DirectMeasurement> direct = {};  ///< the direct measurement; empty: a reading
    double first_cost = 0;  ///< cost of filling the cell before the first reading [dry readings]
    double wait = 0;        ///< waiting time after the study's last reading [s]
    double wait_cost = 0;   ///< cost of the waiting time [dry readings]
    double cost = 1;        ///< cost of each reading [dry readings]
};

/// Value that a rival model predicts at one point, (shear stress [Pa], solid fraction [1]) or the
/// number of a direct measurement [its unit], with its errors.
struct Forecast {
    Eigen::VectorXd value;
    Eigen::MatrixXd from_parameters;  ///< covariance from errors of the rival's parameters
    Eigen::MatrixXd from_simulation;  ///< covariance from errors of the simulation
};

/// Noncentrality of chi2 [1] from which on a test at 5 % significance distinguishes two rival
/// models with a power of 0.8. `telling_noncentrality` is for two observables, and also serves for
/// several points together; `telling_directly` is for the single number of a direct measurement.
inline constexpr double telling_noncentrality = 9.63, telling_directly = 7.85;

}  // namespace pendular
