#include "calib/rumpf.h"

#include "sim/closures/strength.h"
#include "sim/effect.h"

namespace pendular {

void RumpfModel::improve(const Eigen::VectorXd& parameters, double excess) {
    simulation_.predict_for(conditions());
    simulation_.improve(parameters, excess);
}

Prediction RumpfModel::ask(const Eigen::VectorXd& parameters,
                           const std::vector<Condition>& conditions, Ask what) const {
    // Each wet condition together with its dry twin, which gives the dry law.
    std::vector<Condition> with_twins = conditions;
    for (const auto& condition : conditions) {
        if (!condition.dry()) {
            with_twins.push_back(condition);
            with_twins.back().liquid_content = 0;
            std::erase_if(with_twins.back().grain_effects, [](const EffectValues& values) {
                return built_in_effect(values.effect).touches != Touches::all;
            });
        }
    }
    const FlowModel& simulation = simulation_;
    const Prediction simulated = (simulation.*what)(parameters, with_twins);
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
        const double pressure = 1 / inverse_pressure_of(condition, study_);
        const auto z = simulation_.effective_coordination(parameters(0), condition);
        const StructureResponse shear =
            terms_.capillary_shear_stress
                ? simulation_.capillary_shear_stress(parameters(0), condition)
                : StructureResponse{};
        const double dry = simulated.value(twin), fraction = simulated.value(2 * k + 1);
        const double dry_ratio = dry / condition.normal_stress;
        // mu* is linear in each of mu*_dry, Phi_S and Z*: its slopes are ratios.
        const double wet =
            condition.normal_stress *
            closures::stress_ratio_from_cohesion(
                dry_ratio, closures::reduced_cohesion(dry_ratio, fraction, z.value), pressure);
        const double lost = condition.normal_stress / pressure;  // by a unit of shear stress
        const double by_fraction = (wet - dry) / fraction, by_z = (wet - dry) / z.value;
        map(2 * k, 2 * k) = 0;
        map(2 * k, twin) = wet / dry;
        map(2 * k, 2 * k + 1) = by_fraction;
        result.value(2 * k) = wet - lost * shear.value;
        result.jacobian.row(2 * k) = wet / dry * simulated.jacobian.row(twin) +
                                     by_fraction * simulated.jacobian.row(2 * k + 1);
        result.jacobian(2 * k, 0) += by_z * z.by_friction - lost * shear.by_friction;
        twin += 2;
    }
    if (simulated.covariance.size() > 0) {
        result.covariance = map * simulated.covariance * map.transpose();
        result.run_noise = map * simulated.run_noise * map.transpose();
    }
    return result;
}

}  // namespace pendular
