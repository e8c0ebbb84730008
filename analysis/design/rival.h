#pragma once

#include <memory>
#include <optional>
#include <string>

#include "calib/model/predictor.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Name of the rival model that adds no effect to the study's model.
inline constexpr const char* present_model = "the model as it is";

/// Rival model: one of several models of a study among which measurements are to decide, with its
/// fitted parameters.
struct Rival {
    /// Name of the rival model: the effects that it adds to the study's model or, if it adds none,
    /// "the model as it is".
    std::string name;
    /// The rival model itself, as a predictor of readings.
    std::shared_ptr<const Predictor> model;
    /// Fitted parameters of the rival model, in the order of `model->parameters()`.
    Eigen::VectorXd parameters;
    /// Covariance of the errors of the rival model's fitted `parameters`.
    Eigen::MatrixXd covariance;
};

/// Possible next measurement with its cost: a reading of steady shear at a condition, or a direct
/// measurement of one parameter without shearing grains. The unit of costs is the cost of one dry
/// reading.
struct Point {
    Condition condition = {};  ///< condition of the reading; unused if `direct` is given
    /// Direct measurement of a parameter, without shearing grains; empty: the point is a reading of
    /// steady shear.
    std::optional<DirectMeasurement> direct = {};
    /// Cost of refilling the cell before the first reading at the point, if the point has another
    /// filling than the study [cost of a dry reading].
    double first_cost = 0;
    /// Waiting time between the study's last reading and the measurement at the point [s].
    double wait = 0;
    /// Cost of the waiting time before the measurement [cost of a dry reading].
    double wait_cost = 0;
    double cost = 1;  ///< cost of each reading at the point [cost of a dry reading]
};

/// Prediction of a rival model at one point with its errors: (shear stress [Pa], solid fraction
/// [1]) or, for a direct measurement, the value of the measured parameter [its unit].
struct Forecast {
    /// Values that the rival model predicts at the point: shear stress [Pa] and solid fraction [1],
    /// or the one value of a direct measurement [its unit].
    Eigen::VectorXd value;
    /// Covariance of the errors of `value` that come from errors of the rival's fitted parameters.
    Eigen::MatrixXd from_parameters;
    /// Covariance of the errors of `value` that come from errors of the simulation.
    Eigen::MatrixXd from_simulation;
};

/// Smallest noncentrality of chi2 [1] at which a test at 5 % significance tells two rival models
/// apart with a probability of 0.8: for the two observables of a reading (`telling_noncentrality`,
/// also used for several points together), and for the single number of a direct measurement
/// (`telling_directly`).
inline constexpr double telling_noncentrality = 9.63, telling_directly = 7.85;

}  // namespace pendular
