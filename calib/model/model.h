#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/effect_parameter.h"
#include "data/reading.h"
#include "sim/catalogue/resolved_study.h"

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
    /// stiffness of the study's grains, the discrepancy of the model, and the errors of fitted
    /// constant cohesions.
    Eigen::MatrixXd covariance;
    /// Part of `covariance` due to the noise of the simulation runs, which more runs would reduce.
    Eigen::MatrixXd run_noise;
    /// Part of `covariance` due to the discrepancy that is expected of the study's model; empty for
    /// an exact model.
    Eigen::MatrixXd discrepancy = {};
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

/// Candidate for addition to a model, such as an effect that the model lacks.
struct Candidate {
    std::string name;
    std::vector<EffectParameter> parameters;
    std::string group = {};  ///< heading in tables of candidates, such as "instrument"
    /// Rank, from 1, in a sequence in which each candidate includes those of lower rank, such as
    /// the ever more accurate formulas for the stress ratio of wet grains; 0 outside of a sequence.
    int level = 0;

    /// Whether the candidate is present or absent and has no parameter to fit.
    bool is_switch() const;
    /// Returns the number of parameters that the candidate adds to a fit; 0 for a switch.
    std::size_t free_parameters() const;
};

/// Indices in ModelSpace::candidates() of the candidates added to a bare model. In the resulting
/// model, their parameters follow those of the bare model, in the order of the indices.
using EffectSet = std::vector<std::size_t>;

/// Set of models: a bare model, and all models that contain candidates in addition to it. Several
/// threads may use one set of models at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    virtual const std::vector<Candidate>& candidates() const = 0;

    /// Returns the bare model with the candidates `chosen` added. The parameters of the bare model
    /// come first. A switch has no parameter.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Returns the number of values that the models themselves fit to the readings, such as
    /// constant cohesions. They are no parameters of a model, but each reduces the degrees of
    /// freedom of the misfit by one.
    virtual int internally_fitted_values() const { return 0; }

    /// Covariances that simulation errors cause in the change g = f(with) - f(without) of the n
    /// predicted values when a candidate is added: n x n matrices in products of the units of the
    /// values, empty if the errors are negligible.
    struct ChangeErrors {
        Eigen::MatrixXd change;        ///< Cov(g, g)
        Eigen::MatrixXd with_without;  ///< Cov(f(without), g)
    };
    /// Returns the covariances for the addition of `added` to the model with `chosen`; empty by
    /// default.
    /// @param parameters parameter values of the model with the candidates `chosen`
    /// @param values of the free parameters of `added`; none for a switch
    virtual ChangeErrors change_errors(const EffectSet& /*chosen*/,
                                       const Eigen::VectorXd& /*parameters*/, std::size_t /*added*/,
                                       const Eigen::VectorXd& /*values*/) const {
        return {};
    }
};

}  // namespace pendular
