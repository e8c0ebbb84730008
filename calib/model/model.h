#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "sim/catalogue/direct_measurement.h"

namespace pendular {

/// Parameter of a fit: its range and the value where a fit starts.
struct Parameter {
    std::string name;
    std::string unit = "1";
    double lower = 0;  ///< [unit]
    double upper = 0;  ///< [unit]
    double start = 0;  ///< [unit]
};

/// Requested part of a prediction; each part includes the parts before it.
enum class PredictionPart { values, slopes, covariance };

/// Prediction of n readings with its errors. Entries 2 k and 2 k + 1 belong to reading k: its shear
/// stress magnitude [Pa] and its solid fraction [1]. Where direct measurements are predicted too, m
/// entries follow, one for each in its unit. Parts that were not requested are empty.
struct Prediction {
    Eigen::VectorXd value;     ///< 2 n + m entries
    Eigen::MatrixXd jacobian;  ///< derivatives of `value` by the parameters, a column for each
    /// Covariance of the model's errors of `value`, (2 n + m) x (2 n + m): noise of the runs and
    /// errors of all corrections.
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd run_noise;  ///< part of `covariance` that more runs would reduce
};

/// Index of a directly measured parameter among the model's parameters; empty where the model lacks
/// it.
std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters);

/// Prediction of a direct measurement by a model with these parameters and their values, in the
/// unit of the measured parameter: the parameter's value, or its neutral value where the model
/// lacks it.
double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values);

/// Appends `by` rows and columns of zeros to a square matrix; an empty matrix stays empty.
void widen(Eigen::MatrixXd& square, Eigen::Index by);

/// Range of each parameter over which simulation supports a model's predictions.
struct ParameterBounds {
    Eigen::VectorXd lower, upper;
};

/// Model that predicts the readings of a study as functions of its parameters. The returned
/// derivatives are those of the returned values, so that a least-squares solver never
/// differentiates noise. A model never changes, so that any number of threads may use it at once.
class Model {
  public:
    virtual ~Model() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Prediction of all readings at `parameters`, given in the order of parameters().
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Range of parameters that simulation supports.
    virtual ParameterBounds bounds() const = 0;
};

}  // namespace pendular
