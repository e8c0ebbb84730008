#include "calib/model.h"

namespace pendular {

FlowModel::Point FlowModel::predict_at(const Eigen::VectorXd& parameters,
                                       const Condition& condition) const {
    const Prediction prediction = predict_conditions(parameters, {condition});
    const Eigen::Vector2d scale(1 / condition.normal_stress, 1);
    return {scale.cwiseProduct(Eigen::Vector2d(prediction.value)),
            scale.asDiagonal() * Eigen::Matrix2d(prediction.covariance) * scale.asDiagonal()};
}

}  // namespace pendular
