#include "calib/rumpf.h"

#include <numbers>

namespace pendular {

void RumpfModel::improve(const Eigen::VectorXd& parameters, double excess) {
    simulation_.predict_for(conditions());
    simulation_.improve(parameters, excess);
}

Prediction RumpfModel::predict_conditions(const Eigen::VectorXd& parameters,
                                          const std::vector<Condition>& conditions) const {
    // Each wet condition together with its dry twin, which gives the dry law.
    std::vector<Condition> with_twins = conditions;
    for (const auto& condition : conditions) {
        if (!condition.dry()) {
            with_twins.push_back(condition);
            with_twins.back().liquid_content = 0;
        }
    }
    const Prediction simulated = simulation_.predict_conditions(parameters, with_twins);
    const auto n = static_cast<Eigen::Index>(conditions.size());
    Prediction result{.value = simulated.value.head(2 * n),
                      .jacobian = simulated.jacobian.topRows(2 * n),
                      .covariance = {},
                      .run_noise = {}};
    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(2 * n, simulated.value.size());
    Eigen::Index twin = 2 * n;
    for (Eigen::Index k = 0; k < n; ++k) {
        const Condition& condition = conditions[static_cast<std::size_t>(k)];
        if (condition.dry()) {
            continue;
        }
        const double u =
            1 / reduced_pressure(condition.normal_stress, study_.grains, *study_.liquid);
        const auto z = simulation_.effective_coordination(parameters(0), condition);
        const double dry = simulated.value(twin), fraction = simulated.value(2 * k + 1);
        const double growth = 1 + fraction * z.value * u / std::numbers::pi;
        const double by_fraction = dry * z.value * u / std::numbers::pi;
        map(2 * k, 2 * k) = 0;
        map(2 * k, twin) = growth;
        map(2 * k, 2 * k + 1) = by_fraction;
        result.value(2 * k) = dry * growth;
        result.jacobian.row(2 * k) =
            growth * simulated.jacobian.row(twin) + by_fraction * simulated.jacobian.row(2 * k + 1);
        result.jacobian(2 * k, 0) += dry * fraction * u / std::numbers::pi * z.by_friction;
        twin += 2;
    }
    result.covariance = map * simulated.covariance * map.transpose();
    result.run_noise = map * simulated.run_noise * map.transpose();
    return result;
}

}  // namespace pendular
