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
    double lower = 0;  ///< lower end of the range [unit]
    double upper = 0;  ///< upper end of the range [unit]
    double start = 0;  ///< value where a fit starts [unit]
};

/// Requested part of a `Prediction`: its values, also its Jacobian (`slopes`), or also its
/// covariances; each includes the parts before it.
enum class PredictionPart { values, slopes, covariance };

/// Prediction of n readings with its errors. Entries 2 k and 2 k + 1 belong to reading k: its shear
/// stress magnitude [Pa] and its solid fraction [1]. Where direct measurements are predicted too, m
/// entries follow, one for each in its unit. Parts that were not requested are empty.
struct Prediction {
    Eigen::VectorXd value;     ///< predicted values: 2 n + m entries
    Eigen::MatrixXd jacobian;  ///< derivatives of `value` by the parameters, a column for each
    /// Covariance of the model's errors of `value`, (2 n + m) x (2 n + m): noise of the simulation
    /// runs and errors of all corrections, such as that to the study's stiffness.
    Eigen::MatrixXd covariance;
    /// Part of `covariance` from the noise of the runs, which more runs would reduce.
    Eigen::MatrixXd run_noise;
};

/// Index in `parameters` of the effect's parameter that `direct` measures; empty where the model
/// has no such parameter.
std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters);

/// Value that a model predicts for a direct measurement, in the unit of the measured parameter: the
/// entry of `values` for this parameter or, where `parameters` lacks it, its neutral value (no
/// effect).
double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values);

/// Appends `by` rows and columns of zeros to a square matrix; an empty matrix stays empty.
void widen(Eigen::MatrixXd& square, Eigen::Index by);

/// Range of each parameter over which simulation supports a model's predictions, in the parameter's
/// unit and the order of Model::parameters().
struct ParameterBounds {
    Eigen::VectorXd lower, upper;
};

/// Model that predicts the readings of a study as functions of its parameters. The returned
/// derivatives are the exact derivatives of the returned values, so that a least-squares solver
/// never differentiates noise. A model never changes, so that any number of threads may use it at
/// once.
class Model {
  public:
    virtual ~Model() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predicts shear stress [Pa] and solid fraction [1] of all readings at `parameters`, given in
    /// the order of parameters(); `what` selects values, derivatives or covariances.
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Range of each parameter over which simulation supports the predictions.
    virtual ParameterBounds bounds() const = 0;
};

}  // namespace pendular
