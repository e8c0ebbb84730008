#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "calib/model/model.h"
#include "sim/catalogue/effective_condition.h"

namespace pendular {

/// Model that predicts shear stress and solid fraction as an instrument shows them, at any
/// conditions, while a `Model` predicts one given set of readings. A predictor never changes, so
/// that any number of threads may use it at once.
class Predictor {
  public:
    virtual ~Predictor() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predicts shear stress [Pa] and solid fraction [1] at each condition, stacked as `Prediction`
    /// describes, at `parameters` in the order of parameters(); `what` selects values, derivatives
    /// or covariances.
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               const std::vector<Condition>& conditions,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    /// Range of each parameter over which simulation supports the predictions.
    virtual ParameterBounds bounds() const = 0;

    /// Predicted stress ratio [1] and solid fraction [1], in this order, with the covariance of
    /// their errors.
    struct Point {
        Eigen::Vector2d value;
        Eigen::Matrix2d covariance;
    };
    /// Predicts stress ratio and solid fraction at one condition, such as a point of a curve, at
    /// `parameters` in the order of parameters().
    Point predict_at(const Eigen::VectorXd& parameters, const Condition& condition) const;
};

/// Predictions of a `FlowPredictor` near given conditions, for difference quotients over short
/// steps.
class FlowNeighbourhood {
  public:
    virtual ~FlowNeighbourhood() = default;
    /// Predicts true shear stress [Pa] and solid fraction [1], stacked as `Prediction` describes,
    /// at `parameters` and each of the conditions, both a short step away from those at which the
    /// neighbourhood was made.
    /// @param places index of each condition among those at which the neighbourhood was made
    virtual Eigen::VectorXd values(const Eigen::VectorXd& parameters,
                                   const std::vector<EffectiveCondition>& conditions,
                                   const std::vector<std::size_t>& places) const = 0;
};

/// Predictor of the true shear stress and solid fraction in the cell, before an instrument shows
/// them.
class FlowPredictor : public Predictor {
  public:
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const final;
    /// Predicts true shear stress [Pa] and solid fraction [1] at each condition, with grains and
    /// liquid as effects have changed them, stacked as `Prediction` describes.
    virtual Prediction predict_flow(const Eigen::VectorXd& parameters,
                                    const std::vector<EffectiveCondition>& conditions,
                                    PredictionPart what = PredictionPart::covariance) const = 0;
    /// Prepares predictions near `parameters` and `conditions`; by default, they are predicted by
    /// `predict_flow`. The predictor must outlive the result.
    virtual std::unique_ptr<const FlowNeighbourhood> neighbourhood(
        const Eigen::VectorXd& parameters, const std::vector<EffectiveCondition>& conditions) const;
};

/// Returns the prediction `readings` extended by an entry for each direct measurement, predicted at
/// the parameter values `values`; these entries have no simulation error.
Prediction with_direct(Prediction readings, const std::vector<DirectMeasurement>& direct,
                       const std::vector<Parameter>& parameters, const Eigen::VectorXd& values);

/// Model made from a predictor: it predicts the readings at the given conditions, then the given
/// direct measurements (of effects' parameters).
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
