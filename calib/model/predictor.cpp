#include "calib/model/predictor.h"

namespace pendular {
namespace {

/// Neighbourhood in which everything is predicted anew.
class PredictedAnew : public FlowNeighbourhood {
  public:
    explicit PredictedAnew(const FlowPredictor& predictor) : predictor_(predictor) {}
    Eigen::VectorXd values(const Eigen::VectorXd& parameters,
                           const std::vector<EffectiveCondition>& conditions,
                           const std::vector<std::size_t>&) const override {
        return predictor_.predict_flow(parameters, conditions, PredictionPart::values).value;
    }

  private:
    const FlowPredictor& predictor_;
};

}  // namespace

const std::vector<SharedUncertainty>& Predictor::uncertainties() const {
    static const std::vector<SharedUncertainty> none;
    return none;
}

Predictor::Point Predictor::predict_at(const Eigen::VectorXd& parameters,
                                       const Condition& condition) const {
    const Prediction prediction = predict(parameters, {condition});
    const Eigen::Vector2d scale(1 / condition.normal_stress, 1);
    return {scale.cwiseProduct(Eigen::Vector2d(prediction.value)),
            scale.asDiagonal() * Eigen::Matrix2d(prediction.covariance) * scale.asDiagonal()};
}

Prediction FlowPredictor::predict(const Eigen::VectorXd& parameters,
                                  const std::vector<Condition>& conditions,
                                  PredictionPart what) const {
    return predict_flow(parameters, without_effects(conditions), what);
}

std::unique_ptr<const FlowNeighbourhood> FlowPredictor::neighbourhood(
    const Eigen::VectorXd&, const std::vector<EffectiveCondition>&) const {
    return std::make_unique<PredictedAnew>(*this);
}

Prediction with_direct(Prediction readings, const std::vector<DirectMeasurement>& direct,
                       const std::vector<Parameter>& parameters, const Eigen::VectorXd& values) {
    if (direct.empty()) return readings;
    const auto more = static_cast<Eigen::Index>(direct.size());
    const Eigen::Index n = readings.value.size();
    readings.value.conservativeResize(n + more);
    const bool slopes = readings.jacobian.size() > 0;
    if (slopes) {
        readings.jacobian.conservativeResize(n + more, Eigen::NoChange);
        readings.jacobian.bottomRows(more).setZero();
    }
    widen(readings.covariance, more);
    widen(readings.run_noise, more);
    widen(readings.discrepancy, more);
    for (Eigen::Index k = 0; k < more; ++k) {
        const DirectMeasurement& each = direct[static_cast<std::size_t>(k)];
        readings.value(n + k) = predicted_value(each, parameters, values);
        const auto place = place_of(each, parameters);
        if (slopes && place) readings.jacobian(n + k, *place) = 1;
    }
    return readings;
}

}  // namespace pendular
