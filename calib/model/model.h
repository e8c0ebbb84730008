#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "sim/catalogue/direct_measurement.h"

namespace pendular {

/// Parameter of a model to fit: its name, its range and the value where a fit starts.
struct Parameter {
    std::string name;
    std::string unit = "1";
    /// Lower end of the range of the parameter [unit].
    double lower = 0;
    /// Upper end of the range of the parameter [unit].
    double upper = 0;
    /// Value of the parameter where a fit starts [unit].
    double start = 0;
};

/// Requested part of a `Prediction`: values; values and derivatives with respect to the parameters;
/// or values, derivatives and covariances.
enum class PredictionPart { values, slopes, covariance };

/// Prediction of n readings and m direct measurements (of parameters, without shearing grains),
/// with its errors. Entries 2 k and 2 k + 1 of `value` are the shear stress magnitude [Pa] and the
/// solid fraction [1] of reading k (k = 0, 1, ...); the last m entries are the direct measurements,
/// each in its unit. Parts that were not requested are empty.
struct Prediction {
    /// Predicted values: 2 n entries for the readings, then m entries for the direct measurements.
    Eigen::VectorXd value;
    /// Derivatives of `value` with respect to the parameters: a row for each value, a column for
    /// each parameter
    Eigen::MatrixXd jacobian;
    /// Covariance of the errors of `value` that come from the model, (2 n + m) x (2 n + m): noise
    /// of the simulation runs, and errors of corrections such as the correction to the stiffness of
    /// the study's grains.
    Eigen::MatrixXd covariance;
    /// Part of `covariance` that comes from the noise of the simulation runs and that more runs
    /// would reduce.
    Eigen::MatrixXd run_noise;
};

/// Returns the index, in `parameters`, of the parameter whose value the direct measurement `direct`
/// gives; empty if the model has no such parameter.
std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters);

/// Returns the value that a model predicts for the direct measurement of a parameter, in the unit
/// of the parameter. This is the parameter's entry in `values` or, if the model lacks the
/// parameter, the neutral value, at which the effect vanishes.
/// @param parameters parameters of the model
/// @param values values of these parameters, in their order
double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values);

/// Appends `by` rows and `by` columns of zeros to a square matrix. An empty matrix stays empty.
void widen(Eigen::MatrixXd& square, Eigen::Index by);

/// Range of each parameter within which simulation runs support a model's predictions, in the
/// parameter's unit and in the order of Model::parameters().
struct ParameterBounds {
    Eigen::VectorXd lower, upper;
};

/// Model that predicts a given set of readings as a function of its parameters. The returned
/// derivatives are the exact derivatives of the returned values, so that a least-squares solver
/// never differentiates noise. A model never changes, so that several threads may use it at once.
class Model {
  public:
    virtual ~Model() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predicts shear stress [Pa] and solid fraction [1] of all readings.
    /// @param parameters values of the parameters, in the order of parameters()
    /// @param what parts to compute: values, derivatives or covariances
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Range of each parameter within which simulation runs support the predictions.
    virtual ParameterBounds bounds() const = 0;
};

}  // namespace pendular
