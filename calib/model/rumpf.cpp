#include "calib/model/rumpf.h"

#include "calib/model/study_state.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/strength.h"

namespace pendular {

std::vector<EffectiveCondition> with_dry_twins(const std::vector<EffectiveCondition>& conditions) {
    std::vector<EffectiveCondition> all = conditions;
    for (const auto& condition : conditions) {
        if (!condition.dry()) {
            all.push_back(condition);
            all.back().liquid_content = 0;
            std::erase_if(all.back().grain_effects, [](const EffectValues& values) {
                return built_in_effect(values.effect).touches != Touches::all;
            });
        }
    }
    return all;
}

RumpfModel::Closure RumpfModel::closure_at(double friction,
                                           const EffectiveCondition& condition) const {
    return {.z = simulation_->effective_coordination(friction, condition),
            .shear = terms_.capillary_shear_stress
                         ? simulation_->capillary_shear_stress(friction, condition)
                         : StructureResponse{},
            .pressure = 1 / inverse_pressure_of(condition, study_)};
}

double RumpfModel::Closure::rumpf_stress(double dry, double fraction,
                                         const EffectiveCondition& condition) const {
    const double ratio = dry / condition.normal_stress;
    return condition.normal_stress *
           closures::stress_ratio_from_cohesion(
               ratio, closures::reduced_cohesion(ratio, fraction, z.value), pressure);
}

Eigen::VectorXd RumpfModel::predict_values(
    const Eigen::VectorXd& parameters, const std::vector<EffectiveCondition>& conditions) const {
    const Eigen::VectorXd simulated =
        simulation_->predict_flow(parameters, with_dry_twins(conditions), PredictionPart::values)
            .value;
    const auto n = static_cast<Eigen::Index>(conditions.size());
    Eigen::VectorXd values = simulated.head(2 * n);
    Eigen::Index twin = 2 * n;
    for (Eigen::Index k = 0; k < n; ++k) {
        const EffectiveCondition& condition = conditions[static_cast<std::size_t>(k)];
        if (condition.dry()) {
            continue;
        }
        const Closure closure = closure_at(parameters(0), condition);
        values(2 * k) = closure.rumpf_stress(simulated(twin), simulated(2 * k + 1), condition) -
                        condition.normal_stress / closure.pressure * closure.shear.value;
        twin += 2;
    }
    return values;
}

Prediction RumpfModel::predict_flow(const Eigen::VectorXd& parameters,
                                    const std::vector<EffectiveCondition>& conditions,
                                    PredictionPart what) const {
    if (what == PredictionPart::values) {
        return {.value = predict_values(parameters, conditions),
                .jacobian = {},
                .covariance = {},
                .run_noise = {}};
    }
    const Prediction simulated =
        simulation_->predict_flow(parameters, with_dry_twins(conditions), what);
    const auto n = static_cast<Eigen::Index>(conditions.size());
    Prediction result{.value = simulated.value.head(2 * n),
                      .jacobian = simulated.jacobian.topRows(2 * n),
                      .covariance = {},
                      .run_noise = {}};
    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(2 * n, simulated.value.size());
    Eigen::Index twin = 2 * n;
    for (Eigen::Index k = 0; k < n; ++k) {
        const EffectiveCondition& condition = conditions[static_cast<std::size_t>(k)];
        if (condition.dry()) {
            continue;
        }
        const Closure closure = closure_at(parameters(0), condition);
        const auto& [z, shear, pressure] = closure;
        const double dry = simulated.value(twin), fraction = simulated.value(2 * k + 1);
        // mu* is linear in each of mu*_dry, Phi_S and Z*: its slopes are ratios.
        const double wet = closure.rumpf_stress(dry, fraction, condition);
        const double lost = condition.normal_stress / pressure;  // F0/a^2, unit of `shear` [Pa]
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
