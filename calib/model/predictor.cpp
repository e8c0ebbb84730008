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

namespace {

/// Appends the predicted values of directly measured parameters.
void append(Prediction& readings, const std::vector<DirectMeasurement>& direct,
            const std::vector<Parameter>& parameters, const Eigen::VectorXd& values) {
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
}

}  // namespace

Eigen::MatrixXd changes_of_direct(const Predictor& predictor,
                                  const std::vector<DirectMeasurement>& direct) {
    const auto& uncertainties = predictor.uncertainties();
    Eigen::MatrixXd changes(std::ssize(direct), std::ssize(uncertainties));
    for (std::size_t row = 0; row < direct.size(); ++row)
        for (std::size_t k = 0; k < uncertainties.size(); ++k)
            changes(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)) =
                direct[row].change_by(uncertainties[k]);
    return changes;
}

Prediction predict_with_direct(const Predictor& predictor, const Eigen::VectorXd& parameters,
                               const std::vector<Condition>& conditions,
                               const std::vector<DirectMeasurement>& direct, PredictionPart what) {
    Prediction result = predictor.predict(parameters, conditions, what);
    if (direct.empty()) return result;
    const Eigen::Index n = result.value.size(), more = std::ssize(direct);
    append(result, direct, predictor.parameters(), parameters);
    if (what != PredictionPart::covariance) return result;
    Eigen::MatrixXd measured = changes_of_direct(predictor, direct);
    for (Eigen::Index k = 0; k < measured.cols(); ++k)
        if (!predictor.uncertainties()[static_cast<std::size_t>(k)].counts)
            measured.col(k).setZero();
    if (measured.isZero(0)) return result;
    const Eigen::MatrixXd both =
        predictor.shared_changes(parameters, conditions) * measured.transpose();
    result.covariance.topRightCorner(n, more) += both;
    result.covariance.bottomLeftCorner(more, n) += both.transpose();
    result.covariance.bottomRightCorner(more, more) += measured * measured.transpose();
    return result;
}

}  // namespace pendular
