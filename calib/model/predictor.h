#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "calib/model/model.h"
#include "sim/catalogue/effective_condition.h"

namespace pendular {

/// Predictor of the shear stress [Pa] and solid fraction [1] that an instrument shows at any
/// conditions, whereas a `Model` predicts one given set of readings. A predictor never changes, so
/// that several threads may use one predictor at once.
class Predictor {
  public:
    virtual ~Predictor() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predicts the shear stress [Pa] and solid fraction [1] that the instrument shows at each
    /// condition. For condition k (k = 0, 1, ...), entry 2 k of the predicted values is the shear
    /// stress and entry 2 k + 1 the solid fraction.
    /// @param parameters values of the parameters, in the order of parameters()
    /// @param what extent of the prediction: only values, values and derivatives, or values,
    ///        derivatives and covariances
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               const std::vector<Condition>& conditions,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Returns the range of each parameter, in the parameter's unit, in which the predictor can
    /// predict: for the friction coefficient, the range of the simulation runs, and for a parameter
    /// of an effect, its allowed values.
    virtual ParameterBounds bounds() const = 0;

    /// Whether effects of the instrument change what it shows (`Condition::ideal_instrument`).
    virtual bool has_instrument() const { return false; }

    /// Predicted stress ratio [1] (index 0) and solid fraction [1] (index 1) at one condition, with
    /// the covariance matrix of their errors.
    struct Point {
        Eigen::Vector2d value;
        Eigen::Matrix2d covariance;
    };
    /// Predicts the stress ratio [1] and the solid fraction [1] at one condition, such as a point
    /// of a curve.
    /// @param parameters values of the parameters, in the order of parameters()
    Point predict_at(const Eigen::VectorXd& parameters, const Condition& condition) const;
};

/// Fast predictions of a `FlowPredictor` near given parameter values and conditions, from which
/// derivatives are computed as difference quotients over short steps.
class FlowNeighbourhood {
  public:
    virtual ~FlowNeighbourhood() = default;
    /// Predicts the true shear stress [Pa] and solid fraction [1] at each condition in turn.
    /// Parameters and conditions must be close to the parameters and conditions for which the
    /// object was made.
    /// @param places for each condition, the index of the nearby condition in the list for which
    ///        the object was made
    virtual Eigen::VectorXd values(const Eigen::VectorXd& parameters,
                                   const std::vector<EffectiveCondition>& conditions,
                                   const std::vector<std::size_t>& places) const = 0;
};

/// Predictor of the true shear stress [Pa] and solid fraction [1] in the cell, from which the
/// values that the instrument shows may differ.
class FlowPredictor : public Predictor {
  public:
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const final;
    /// Predicts the true shear stress [Pa] and solid fraction [1] at each condition in turn. The
    /// conditions may contain changes that effects make to grains and liquid.
    /// @param parameters values of the parameters, in the order of parameters()
    /// @param what extent of the prediction: only values, values and derivatives, or values,
    ///        derivatives and covariances
    virtual Prediction predict_flow(const Eigen::VectorXd& parameters,
                                    const std::vector<EffectiveCondition>& conditions,
                                    PredictionPart what = PredictionPart::covariance) const = 0;
    /// Returns an object that makes fast predictions near the parameter values `parameters` and
    /// near `conditions`, for difference quotients. The predictor must outlive the returned object.
    /// By default, the returned object calls `predict_flow`.
    virtual std::unique_ptr<const FlowNeighbourhood> neighbourhood(
        const Eigen::VectorXd& parameters, const std::vector<EffectiveCondition>& conditions) const;
};

/// Returns the prediction `readings` of the readings, with the predicted value of each directly
/// measured parameter in `direct` appended. The predicted value is the value of the parameter in
/// `values`. If the model lacks the parameter, the predicted value is `DirectMeasurement::neutral`.
/// The appended entries have no simulation error.
/// @param parameters parameters of the model
/// @param values values of the parameters, in the order of `parameters`
Prediction with_direct(Prediction readings, const std::vector<DirectMeasurement>& direct,
                       const std::vector<Parameter>& parameters, const Eigen::VectorXd& values);

/// Model that predicts first the readings at given conditions, by means of a predictor, then given
/// parameters of effects that were measured directly (without shearing grains).
class ModelOfReadings : public Model {
  public:
    ModelOfReadings(std::shared_ptr<const Predictor> predictor, std::vector<Condition> conditions,
                    std::vector<DirectMeasurement> direct = {})
        : predictor_(std::move(predictor)),
          conditions_(std::move(conditions)),
          direct_(std::move(direct)) {}

    const std::vector<Parameter>& parameters() const override { return predictor_->parameters(); }
    Prediction predict(const Eigen::VectorXd& parameters,
                       PredictionPart what = PredictionPart::covariance) const override {
        return with_direct(predictor_->predict(parameters, conditions_, what), direct_,
                           predictor_->parameters(), parameters);
    }
    ParameterBounds bounds() const override { return predictor_->bounds(); }

  private:
    std::shared_ptr<const Predictor> predictor_;
    std::vector<Condition> conditions_;
    std::vector<DirectMeasurement> direct_;
};

}  // namespace pendular
