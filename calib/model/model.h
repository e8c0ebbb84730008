#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "sim/catalogue/direct_measurement.h"

namespace pendular {

/// Parameter of a model, which a fit determines: name, unit and range of the parameter, and the
/// value at which a fit starts.
struct Parameter {
    std::string name;
    std::string unit = "1";
    /// Lower end of the range of the parameter, in the parameter's unit.
    double lower = 0;
    /// Upper end of the range of the parameter, in the parameter's unit.
    double upper = 0;
    /// Value of the parameter at which a fit starts, in the parameter's unit.
    double start = 0;
};

/// Extent of a requested `Prediction`. `values` requests the predicted values only. `slopes` also
/// requests the derivatives with respect to the parameters. `covariance` requests values,
/// derivatives and covariances.
enum class PredictionPart { values, slopes, covariance };

/// Prediction of n readings and of m parameters of effects that were measured directly, without
/// shearing grains, with the errors of the prediction. Entries 2 k and 2 k + 1 of `value` are the
/// shear stress magnitude [Pa] and the solid fraction [1] of reading k (k = 0, 1, ...). The last m
/// entries are the directly measured parameters, each in its own unit. Members that were not
/// requested (`PredictionPart`) are empty.
struct Prediction {
    /// Predicted values: 2 n entries for the readings, shear stress [Pa] and solid fraction [1] of
    /// each reading in turn, then m entries for the directly measured parameters.
    Eigen::VectorXd value;
    /// Derivatives of `value` with respect to the parameters. The matrix has a row for each value
    /// and a column for each parameter.
    Eigen::MatrixXd jacobian;
    /// Covariance matrix (2 n + m rows and columns) of the errors of `value` that come from the
    /// model. The errors are the noise of the simulation runs, the errors of corrections, such as
    /// the correction to the stiffness of the study's grains, the discrepancy (expected error of
    /// the model) that the study states, and the errors of fitted constant cohesions.
    Eigen::MatrixXd covariance;
    /// Contribution of the noise of the simulation runs to `covariance` (2 n + m rows and columns).
    /// More simulation runs would reduce this contribution.
    Eigen::MatrixXd run_noise;
};

/// Returns the index, in the list `parameters` of a model's parameters, of the parameter that
/// `direct` measures. The result is empty if the model lacks the parameter.
std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters);

/// Returns the value that a model predicts for a parameter of an effect that is measured directly,
/// without shearing grains, in the unit of the parameter: the value of the parameter in `values`.
/// If the model lacks the parameter, the predicted value is `DirectMeasurement::neutral`.
/// @param parameters parameters of the model
/// @param values values of the parameters, in the order of `parameters`
double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values);

/// Appends `by` rows and `by` columns of zeros to a square matrix. An empty matrix stays empty.
void widen(Eigen::MatrixXd& square, Eigen::Index by);

/// Lower and upper end of the range of each parameter of a model, in the units of the parameters
/// and in the order of Model::parameters().
struct ParameterBounds {
    Eigen::VectorXd lower, upper;
};

/// Model that predicts a given set of readings as a function of the model's parameters. The model
/// also returns the derivatives of the predicted values with respect to the parameters, so that a
/// least-squares solver needs no difference quotients of its own. A model never changes, so that
/// several threads may use one model at once.
class Model {
  public:
    virtual ~Model() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predicts the shear stress [Pa] and solid fraction [1] of each reading in turn, followed by
    /// the parameters of effects that were measured directly, each in its own unit.
    /// @param parameters values of the parameters, in the order of parameters()
    /// @param what extent of the prediction: only values, values and derivatives, or values,
    ///        derivatives and covariances
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Returns the range of each parameter, in the parameter's unit, in which the model can
    /// predict: for the friction coefficient, the range of the simulation runs, and for a parameter
    /// of an effect, its allowed values.
    virtual ParameterBounds bounds() const = 0;
};

}  // namespace pendular
