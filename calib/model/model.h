#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "sim/catalogue/direct_measurement.h"

namespace pendular {

/// Parameter of a model, which a fit determines. Range and start are in its unit.
struct Parameter {
    std::string name;
    std::string unit = "1";
    double lower = 0;
    double upper = 0;
    double start = 0;  ///< value at which a fit starts
};

/// Extent of a requested `Prediction`: values; values and derivatives; or also covariances.
enum class PredictionPart { values, slopes, covariance };

/// Prediction of n readings and of m directly measured parameters of effects. Entries 2 k and 2 k +
/// 1 of `value` are the shear stress magnitude [Pa] and the solid fraction [1] of reading k, the
/// last m entries the directly measured parameters, each in its own unit. Members that were not
/// requested are empty.
struct Prediction {
    Eigen::VectorXd value;
    /// Derivatives of `value` (rows) with respect to the parameters (columns).
    Eigen::MatrixXd jacobian;
    /// Covariance matrix (2 n + m rows and columns) of the errors of `value` that come from the
    /// model: the noise of the simulation runs, the errors of corrections, such as that to the
    /// stiffness of the study's grains, the discrepancy that the study states, and the errors of
    /// fitted constant cohesions.
    Eigen::MatrixXd covariance;
    /// Part of `covariance` due to the noise of the simulation runs, which more runs would reduce.
    Eigen::MatrixXd run_noise;
};

/// Returns the index of the parameter that `direct` measures; empty if the model lacks it.
std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters);

/// Returns a model's prediction of a directly measured parameter, in its unit: its value in
/// `values`, or `DirectMeasurement::neutral` if the model lacks it.
double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values);

/// Appends `by` rows and `by` columns of zeros to a square matrix. An empty matrix stays empty.
void widen(Eigen::MatrixXd& square, Eigen::Index by);

/// Range of each parameter of a model, in the units and order of the parameters.
struct ParameterBounds {
    Eigen::VectorXd lower, upper;
};

/// Model that predicts a given set of readings as a function of its parameters. It also returns
/// derivatives, so that a least-squares solver needs no difference quotients of its own. A model
/// never changes, so that several threads may use one model at once.
class Model {
  public:
    virtual ~Model() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predicts the readings and the directly measured parameters (`Prediction`).
    /// @param parameters values of the parameters, in the order of parameters()
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Returns the ranges in which the model can predict: for the friction coefficient, the range
    /// of the simulation runs, and for a parameter of an effect, its allowed values.
    virtual ParameterBounds bounds() const = 0;
};

}  // namespace pendular
