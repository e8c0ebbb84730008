#include "analysis/design/point.h"

#include <cmath>

namespace pendular {

Prediction predicted_at(const FittedModel& rival, const std::vector<Point>& points) {
    const auto& parameters = rival.predictor->parameters();
    std::vector<Condition> conditions;
    Eigen::Index size = 0;
    for (const Point& point : points) {
        if (!point.direct) conditions.push_back(point.condition);
        size += entries_at(point);
    }
    const auto columns = static_cast<Eigen::Index>(parameters.size());
    Prediction all{.value = Eigen::VectorXd(size),
                   .jacobian = Eigen::MatrixXd::Zero(size, columns),
                   .covariance = Eigen::MatrixXd::Zero(size, size),
                   .run_noise = {}};
    Prediction predicted;
    if (!conditions.empty()) predicted = rival.predictor->predict(rival.fit.parameters, conditions);
    std::vector<Eigen::Index> place;  // index in `all` of each entry of the readings
    Eigen::Index entry = 0;
    for (const Point& point : points) {
        if (point.direct) {
            all.value(entry) = predicted_value(*point.direct, parameters, rival.fit.parameters);
            if (const auto own = place_of(*point.direct, parameters)) all.jacobian(entry, *own) = 1;
            ++entry;
            continue;
        }
        const auto from = static_cast<Eigen::Index>(place.size());
        all.value.segment<2>(entry) = predicted.value.segment<2>(from);
        all.jacobian.middleRows<2>(entry) = predicted.jacobian.middleRows<2>(from);
        place.push_back(entry++);
        place.push_back(entry++);
    }
    for (std::size_t a = 0; a < place.size(); ++a) {
        for (std::size_t b = 0; b < place.size(); ++b) {
            all.covariance(place[a], place[b]) =
                predicted.covariance(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
        }
    }
    return all;
}

Eigen::VectorXd noise_at(const std::vector<Point>& points, const Eigen::VectorXd& shown,
                         const Eigen::Vector2d& relative_noise) {
    Eigen::VectorXd variance(shown.size());
    Eigen::Index entry = 0;
    for (const Point& point : points) {
        if (point.direct) {
            variance(entry++) = std::pow(point.direct->standard_error, 2);
            continue;
        }
        variance.segment<2>(entry) =
            relative_noise.cwiseProduct(shown.segment<2>(entry)).cwiseAbs2();
        entry += 2;
    }
    return variance;
}

}  // namespace pendular
