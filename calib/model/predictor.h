#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "calib/model/model.h"
#include "sim/catalogue/effective_condition.h"

namespace pendular {

/// Predicts what an instrument shows at any conditions, such as the simulation behind the readings
/// of a study. A predictor never changes, so that any number of threads may use it at once.
class Predictor {
  public:
    virtual ~Predictor() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Shear stresses [Pa] and solid fractions [1] at these conditions, as in `Prediction`, at
    /// `parameters` (in the order of parameters()).
    virtual Prediction predict(const Eigen::VectorXd& parameters,
                               const std::vector<Condition>& conditions,
                               PredictionPart what = PredictionPart::covariance) const = 0;

    virtual ParameterBounds bounds() const = 0;

    /// (stress ratio [1], solid fraction [1]) with their covariance.
    struct Point {
        Eigen::Vector2d value;
        Eigen::Matrix2d covariance;
    };
    /// Prediction for one condition, for curves.
    Point predict_at(const Eigen::VectorXd& parameters, const Condition& condition) const;
};

/// Predictor of the true flow in the cell, before an instrument shows it.
class FlowPredictor : public Predictor {
  public:
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart what = PredictionPart::covariance) const final;
    /// Prediction of the true flow for grains and liquid as changed by effects.
    virtual Prediction predict_flow(const Eigen::VectorXd& parameters,
                                    const std::vector<EffectiveCondition>& conditions,
                                    PredictionPart what = PredictionPart::covariance) const = 0;
};

/// Predictions of readings, and after them those of direct measurements by the same parameters.
Prediction with_direct(Prediction readings, const std::vector<DirectMeasurement>& direct,
                       const std::vector<Parameter>& parameters, const Eigen::VectorXd& values);

/// A predictor as the model of readings at some conditions and, after them, of direct measurements.
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
