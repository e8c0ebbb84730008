#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "calib/model/model.h"
#include "sim/catalogue/effect.h"
#include "sim/catalogue/shared_uncertainty.h"

namespace pendular {

/// Predictor of the shear stress [Pa] and solid fraction [1] that an instrument shows at any
/// conditions, whereas a `Model` predicts one given set of readings. A predictor never changes, so
/// that several threads may use one at once. Parameter values are in the order of parameters().
class Predictor {
  public:
    virtual ~Predictor() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predicts shear stress [Pa] and solid fraction [1] at each condition in turn (`Prediction`).
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               const std::vector<Condition>& conditions,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Returns the ranges in which the predictor can predict (Model::bounds()).
    virtual ParameterBounds bounds() const = 0;

    /// Whether effects of the instrument change what it shows (`Condition::ideal_instrument`).
    virtual bool has_instrument() const { return false; }

    /// Returns the errors that all readings share, apart from those that effects of the model
    /// contain; none by default.
    virtual const std::vector<SharedUncertainty>& uncertainties() const;
    /// Returns the changes of the predicted values (rows, as in `Prediction::value`) by errors of
    /// one standard uncertainty (columns, in the order of uncertainties()). The covariance of a
    /// prediction contains those that count.
    virtual Eigen::MatrixXd shared_changes(const Eigen::VectorXd& /*parameters*/,
                                           const std::vector<Condition>& conditions) const {
        return Eigen::MatrixXd(2 * static_cast<Eigen::Index>(conditions.size()), 0);
    }

    /// Returns the conditions truly imposed on the grains where the instrument shows `conditions`,
    /// with the changes of grains and liquid by effects.
    virtual std::vector<EffectiveCondition> imposed(
        const Eigen::VectorXd& /*parameters*/, const std::vector<Condition>& conditions) const {
        return without_effects(conditions);
    }

    /// Predicted stress ratio [1] (index 0) and solid fraction [1] (index 1) at one condition, with
    /// the covariance matrix of their errors.
    struct Point {
        Eigen::Vector2d value;
        Eigen::Matrix2d covariance;
    };
    /// Predicts stress ratio and solid fraction at one condition, such as a point of a curve.
    Point predict_at(const Eigen::VectorXd& parameters, const Condition& condition) const;
};

/// Fast predictions of a `FlowPredictor` near given parameter values and conditions, from which
/// derivatives are computed as difference quotients over short steps.
class FlowNeighbourhood {
  public:
    virtual ~FlowNeighbourhood() = default;
    /// Predicts the true shear stress [Pa] and solid fraction [1] at each condition in turn.
    /// Parameters and conditions must be close to those for which the object was made.
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
    virtual Prediction predict_flow(const Eigen::VectorXd& parameters,
                                    const std::vector<EffectiveCondition>& conditions,
                                    PredictionPart what = PredictionPart::covariance) const = 0;
    /// Returns an object for fast predictions near `parameters` and `conditions`. The predictor
    /// must outlive it. By default, the object calls `predict_flow`.
    virtual std::unique_ptr<const FlowNeighbourhood> neighbourhood(
        const Eigen::VectorXd& parameters, const std::vector<EffectiveCondition>& conditions) const;
};

/// Returns the changes of the directly measured parameters (rows, each in its unit) by errors of
/// one standard uncertainty (columns, in the order of Predictor::uncertainties()).
Eigen::MatrixXd changes_of_direct(const Predictor& predictor,
                                  const std::vector<DirectMeasurement>& direct);

/// Returns a prediction of readings with the predicted value of each directly measured parameter
/// appended (`predicted_value`). It has no simulation error, but the error of a gain or an offset
/// that is stated, measured and not in the model changes both the readings and what is measured:
/// the direct measurement thus narrows what was stated.
Prediction predict_with_direct(const Predictor& predictor, const Eigen::VectorXd& parameters,
                               const std::vector<Condition>& conditions,
                               const std::vector<DirectMeasurement>& direct,
                               PredictionPart what = PredictionPart::covariance);

/// Model of readings at given conditions, by a predictor, and of directly measured parameters.
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
        return predict_with_direct(*predictor_, parameters, conditions_, direct_, what);
    }
    ParameterBounds bounds() const override { return predictor_->bounds(); }

  private:
    std::shared_ptr<const Predictor> predictor_;
    std::vector<Condition> conditions_;
    std::vector<DirectMeasurement> direct_;
};

}  // namespace pendular
