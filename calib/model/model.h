#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "sim/catalogue/direct_measurement.h"

namespace pendular {

/// Parameter of a fit.
struct Parameter {
    std::string name;
    std::string unit = "1";
    double lower = 0;
    double upper = 0;
    double start = 0;
};

/// Requested part of a prediction; each part includes the ones before it.
enum class PredictionPart { values, slopes, covariance };

/// Prediction of n readings with its errors. Entries 2 k and 2 k + 1 belong to reading k: its shear
/// stress magnitude [Pa] and its solid fraction [1]. Where direct measurements are predicted too, m
/// entries follow, one for each in its unit. Parts that were not requested are empty.
struct Prediction {
    Eigen::VectorXd value;     ///< 2 n + m
    Eigen::MatrixXd jacobian;  ///< 2 n + m x parameters
    /// 2 n + m squared, of `value`: noise of the runs and the error of every correction.
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd run_noise;  ///< the part of `covariance` that more runs would reduce
};

/// Index of a directly measured parameter among the model's parameters; empty where the model lacks
/// it.
std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters);

/// Prediction of a direct measurement by a model with these parameters: the parameter's value, or
/// its neutral value where the model lacks it.
double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values);

/// Puts as many rows and columns of zeros to the end of a square matrix; an empty one stays so.
void widen(Eigen::MatrixXd& square, Eigen::Index by);

/// The range of parameters over which a model's predictions are supported by simulation.
struct ParameterBounds {
    Eigen::VectorXd lower, upper;
};

/// Predicts the readings of a study as functions of its parameters. The derivatives are those of
/// the value returned, so that a least-squares solver never differentiates noise. A model never
/// changes, so that any number of threads may use it at once.
class Model {
  public:
    virtual ~Model() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predictions at `parameters` (in the order of parameters()).
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    virtual ParameterBounds bounds() const = 0;
};

}  // namespace pendular
