#pragma once

#include <memory>
#include <optional>
#include <string>

#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Name of the rival model (`Rival`) that is the study's model itself, without an additional
/// effect.
inline constexpr const char* present_model = "the model as it is";

/// Rival model: one of several fitted models of a study that measurements are to tell apart.
struct Rival {
    /// Names of the effects that the rival model adds to the study's model, joined by " + " and
    /// preceded by a number such as "proposal 1: " if Pendular proposed the effects.
    /// `present_model` if the rival model adds no effect.
    std::string name;
    /// Predictor of the shear stress [Pa] and solid fraction [1] by the rival model, at any
    /// conditions and for any values of the model's parameters.
    std::shared_ptr<const Predictor> model;
    /// Fitted values of the rival model's parameters, in the order and units of
    /// `model->parameters()`.
    Eigen::VectorXd parameters;
    /// Covariance matrix of the errors of the fitted `parameters`, in products of the units of the
    /// parameters: a row and a column for each parameter.
    Eigen::MatrixXd covariance;
    double chi2 = 0;  ///< chi2 [1] for all readings and all direct measurements
};

/// Possible next measurement with its cost. A point is either a reading of steady shear at one
/// condition or a direct measurement of one effect's parameter, without shearing grains. The unit
/// of costs is the cost of one dry reading.
struct Point {
    /// Condition of the reading, such as normal stress and inertial number. Unused if `direct` has
    /// a value.
    Condition condition = {};
    /// Direct measurement of an effect's parameter, without shearing grains. Empty if the point is
    /// a reading of steady shear.
    std::optional<DirectMeasurement> direct = {};
    /// Cost of refilling the cell before the first reading at the point [cost of a dry reading].
    /// The cost is 0 if the volume of beads at the point equals the volume of beads in the study's
    /// cell.
    double first_cost = 0;
    /// Waiting time between the study's last reading and the measurement at the point [s].
    double wait = 0;
    /// Cost of the waiting time `wait` before the measurement [cost of a dry reading].
    double wait_cost = 0;
    double cost = 1;  ///< cost of each reading at the point [cost of a dry reading]
};

/// Prediction of a rival model (one of several models to be told apart) for the measurement at one
/// point, with the errors of the prediction.
struct Forecast {
    /// Values that the rival model predicts at the point. For a reading: shear stress [Pa] and
    /// solid fraction [1]. For a direct measurement of an effect's parameter: the parameter [its
    /// unit].
    Eigen::VectorXd value;
    /// Covariance matrix of the errors of `value` that come from errors of the rival model's fitted
    /// parameters, in products of the units of `value`.
    Eigen::MatrixXd from_parameters;
    /// Covariance matrix of the errors of `value` that come from errors of the simulation, in
    /// products of the units of `value`.
    Eigen::MatrixXd from_simulation;
};

/// Smallest noncentrality of the chi2 distribution [1] at which a test at 5 % significance tells
/// two rival models apart with a probability of 0.8. `telling_noncentrality` holds for the two
/// observables of a reading (two degrees of freedom), and is also used for readings at several
/// points together. `telling_directly` holds for the single value of a direct measurement.
inline constexpr double telling_noncentrality = 9.63, telling_directly = 7.85;

}  // namespace pendular
