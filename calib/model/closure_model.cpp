#include "calib/model/closure_model.h"

#include "calib/model/study_state.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/closure_values.h"
#include "sim/closures/state.h"

namespace pendular {

using closures::Level;

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

/// Quantities that the closure needs at a wet condition.
struct ClosureModel::Closure {
    StructureResponse z;       ///< coordination number [1]; 0 where `normal` is used instead
    StructureResponse normal;  ///< capillary normal stress a^2 s22cap/F0 [1], on strength1
    StructureResponse shear;   ///< capillary shear stress a^2 s12cap/F0 [1], from strength2 on
    double pressure = 0;       ///< reduced pressure P* [1]

    /// Stress ratio [1] from that of dry grains [1] and the solid fraction [1].
    double stress_ratio(double dry, double fraction) const {
        const double attraction = normal.value + closures::capillary_pressure(fraction, z.value);
        return closures::stress_ratio_from_stresses(dry, {attraction, shear.value}, pressure);
    }
    /// Derivative of `stress_ratio` by the stress ratio of dry grains [1].
    double by_dry(double fraction) const {
        return 1 - (normal.value + closures::capillary_pressure(fraction, z.value)) / pressure;
    }
    /// Derivative of `stress_ratio` by the solid fraction [1].
    double by_fraction(double dry) const {
        return -dry * closures::capillary_pressure(1, z.value) / pressure;
    }
    /// Derivative of `stress_ratio` by the friction through the structure alone [1].
    double by_structure(double dry, double fraction) const {
        const double attraction =
            normal.by_friction + closures::capillary_pressure(fraction, z.by_friction);
        return -(dry * attraction + shear.by_friction) / pressure;
    }
};

ClosureModel::Closure ClosureModel::closure_at(double friction,
                                               const EffectiveCondition& condition) const {
    Closure closure{.pressure = 1 / inverse_pressure_of(condition, study_)};
    if (level_ == Level::strength1) {
        closure.normal = simulation_->capillary_normal_stress(friction, condition);
    } else {
        closure.z = level_ == Level::rumpf
                        ? simulation_->approximate_coordination(friction, condition)
                        : simulation_->effective_coordination(friction, condition);
    }
    if (level_ >= Level::strength2) {
        closure.shear = simulation_->capillary_shear_stress(friction, condition);
    }
    return closure;
}

Prediction ClosureModel::predict_flow(const Eigen::VectorXd& parameters,
                                      const std::vector<EffectiveCondition>& conditions,
                                      PredictionPart what) const {
    const Prediction simulated =
        simulation_->predict_flow(parameters, with_dry_twins(conditions), what);
    const auto n = static_cast<Eigen::Index>(conditions.size());
    const bool slopes = what != PredictionPart::values;
    Prediction result{
        .value = simulated.value.head(2 * n), .jacobian = {}, .covariance = {}, .run_noise = {}};
    if (slopes) result.jacobian = simulated.jacobian.topRows(2 * n);
    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(2 * n, slopes ? simulated.value.size() : 0);
    Eigen::Index twin = 2 * n;
    for (Eigen::Index k = 0; k < n; ++k) {
        const EffectiveCondition& condition = conditions[static_cast<std::size_t>(k)];
        if (condition.dry()) {
            continue;
        }
        const Closure closure = closure_at(parameters(0), condition);
        const double s22 = condition.normal_stress, dry = simulated.value(twin) / s22,
                     fraction = simulated.value(2 * k + 1);
        result.value(2 * k) = s22 * closure.stress_ratio(dry, fraction);
        if (slopes) {
            map(2 * k, 2 * k) = 0;
            map(2 * k, twin) = closure.by_dry(fraction);
            map(2 * k, 2 * k + 1) = s22 * closure.by_fraction(dry);
            result.jacobian.row(2 * k) = map.row(2 * k) * simulated.jacobian;
            result.jacobian(2 * k, 0) += s22 * closure.by_structure(dry, fraction);
        }
        twin += 2;
    }
    if (simulated.covariance.size() > 0) {
        result.covariance = map * simulated.covariance * map.transpose();
        result.run_noise = map * simulated.run_noise * map.transpose();
    }
    return result;
}

}  // namespace pendular
