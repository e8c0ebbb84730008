#include "calib/model.h"

#include <algorithm>
#include <utility>

namespace pendular {

void widen(Eigen::MatrixXd& square, Eigen::Index by) {
    if (square.size() == 0) return;  // not asked for
    const Eigen::Index n = square.rows();
    square.conservativeResize(n + by, n + by);
    square.rightCols(by).setZero();
    square.bottomRows(by).setZero();
}

std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters) {
    const auto found = std::ranges::find(parameters, direct.parameter, &Parameter::name);
    if (found == parameters.end()) return std::nullopt;
    return found - parameters.begin();
}

double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values) {
    const auto place = place_of(direct, parameters);
    return place ? values(*place) : direct.neutral;
}

Prediction FlowModel::with_direct(const Eigen::VectorXd& parameters, Prediction readings) const {
    const Eigen::Index more = direct_count();
    if (more == 0) return readings;
    const Eigen::Index n = readings.value.size();
    readings.value = with_direct(parameters, std::move(readings.value));
    readings.jacobian.conservativeResize(n + more, Eigen::NoChange);
    readings.jacobian.bottomRows(more).setZero();
    widen(readings.covariance, more);
    widen(readings.run_noise, more);
    for (Eigen::Index k = 0; k < more; ++k) {
        const auto place = place_of(direct_[static_cast<std::size_t>(k)], this->parameters());
        if (place) readings.jacobian(n + k, *place) = 1;
    }
    return readings;
}

Eigen::VectorXd FlowModel::with_direct(const Eigen::VectorXd& parameters,
                                       Eigen::VectorXd readings) const {
    const Eigen::Index n = readings.size();
    readings.conservativeResize(n + direct_count());
    for (std::size_t k = 0; k < direct_.size(); ++k) {
        readings(n + static_cast<Eigen::Index>(k)) =
            predicted_value(direct_[k], this->parameters(), parameters);
    }
    return readings;
}

FlowModel::Point FlowModel::predict_at(const Eigen::VectorXd& parameters,
                                       const Condition& condition) const {
    const Prediction prediction = predict_conditions(parameters, {condition});
    const Eigen::Vector2d scale(1 / condition.normal_stress, 1);
    return {scale.cwiseProduct(Eigen::Vector2d(prediction.value)),
            scale.asDiagonal() * Eigen::Matrix2d(prediction.covariance) * scale.asDiagonal()};
}

}  // namespace pendular
