#include "calib/fit/structural_cohesion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "calib/model/closure_model.h"
#include "sim/closures/closure_values.h"

namespace pendular {
namespace {

/// Conditions of the readings of a group whose P* is at or above the limit.
std::vector<Condition> fitted_conditions(const WetGroup& group, const Calibration& c,
                                         const CohesionOptions& options) {
    std::vector<Condition> conditions;
    for (const std::size_t k : group.members) {
        const Condition& condition = c.readings[k].condition;
        if (options.fits(reduced_pressure(condition.normal_stress, c.grains, *c.liquid))) {
            conditions.push_back(condition);
        }
    }
    return conditions;
}

/// Pull-off force F0 of the liquid as effects change it, over F0 of the study's liquid [1].
double force_ratio(const EffectiveCondition& imposed, const Calibration& c) {
    return imposed.liquid
               ? pull_off_force(c.grains, *imposed.liquid) / pull_off_force(c.grains, *c.liquid)
               : 1;
}

/// Means of the two cohesions (Rumpf's, generalised) over readings at some conditions [1].
class Means {
  public:
    Means(const StudyModel& model, const Calibration& c, std::vector<Condition> conditions)
        : model_(model), c_(c), conditions_(std::move(conditions)) {}

    /// Means at some parameters. `slopes`, if not null, receives the derivatives of each mean by
    /// the predictions of the simulation, which are equal for both.
    Eigen::Vector2d at(const Eigen::VectorXd& parameters, Eigen::RowVectorXd* slopes = {}) const {
        const EmulatedSimulation& simulation = model_.simulation();
        const std::vector<EffectiveCondition> imposed = model_.imposed(parameters, conditions_);
        const Eigen::VectorXd predicted =
            simulation
                .predict_flow(parameters.head(1), with_dry_twins(imposed), PredictionPart::values)
                .value;
        if (slopes) *slopes = Eigen::RowVectorXd::Zero(predicted.size());
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        auto dry = 2 * static_cast<Eigen::Index>(imposed.size());
        for (std::size_t k = 0; k < imposed.size(); ++k) {
            const EffectiveCondition& condition = imposed[k];
            if (condition.dry()) continue;  // a liquid without surface tension makes no cohesion
            const double share = force_ratio(condition, c_) / static_cast<double>(imposed.size());
            const Eigen::Index fraction = 2 * static_cast<Eigen::Index>(k) + 1;
            const double dry_ratio = predicted(dry) / condition.normal_stress;
            const double z = simulation.effective_coordination(parameters(0), condition).value;
            const double shear = simulation.capillary_shear_stress(parameters(0), condition).value;
            using closures::reduced_cohesion;
            mean(0) += share * reduced_cohesion(dry_ratio, predicted(fraction), z);
            mean(1) +=
                share * closures::generalised_cohesion(dry_ratio, predicted(fraction), z, shear);
            if (slopes) {
                // The cohesion is a product of three factors: its derivative by a factor is the
                // formula with 1 in place of this factor.
                (*slopes)(dry) =
                    share * reduced_cohesion(1, predicted(fraction), z) / condition.normal_stress;
                (*slopes)(fraction) = share * reduced_cohesion(dry_ratio, 1, z);
            }
            dry += 2;
        }
        return mean;
    }

    /// Standard errors of the means at the fitted parameters, from the simulation and from all
    /// fitted parameters.
    Eigen::Vector2d errors() const {
        const Eigen::VectorXd& fitted = c_.fit.parameters;
        Eigen::RowVectorXd slopes;
        at(fitted, &slopes);
        const Eigen::MatrixXd simulated =
            model_.simulation()
                .predict_flow(fitted.head(1), with_dry_twins(model_.imposed(fitted, conditions_)))
                .covariance;
        const Eigen::Matrix2Xd by_parameters = derivatives();
        const Eigen::Matrix2d through_fit =
            by_parameters * c_.fit.total_covariance() * by_parameters.transpose();
        const double by_simulation = slopes * simulated * slopes.transpose();
        return (through_fit.diagonal().array() + by_simulation).sqrt();
    }

  private:
    /// Derivatives of the means by all parameters; 0 for parameters that are known exactly.
    Eigen::Matrix2Xd derivatives() const {
        constexpr double share =
            0.01;  // step in standard errors: far above rounding errors, close to a tangent
        Eigen::Matrix2Xd result = Eigen::Matrix2Xd::Zero(2, c_.fit.parameters.size());
        for (Eigen::Index k = 0; k < result.cols(); ++k) {
            const Parameter& parameter = c_.parameters[static_cast<std::size_t>(k)];
            const double step = share * c_.fit.standard_error(k);
            Eigen::VectorXd above = c_.fit.parameters, below = above;
            above(k) = std::min(above(k) + step, parameter.upper);
            below(k) = std::max(below(k) - step, parameter.lower);
            if (above(k) > below(k)) {
                result.col(k) = (at(above) - at(below)) / (above(k) - below(k));
            }
        }
        return result;
    }

    const StudyModel& model_;
    const Calibration& c_;
    std::vector<Condition> conditions_;
};

}  // namespace

std::vector<StructuralCohesion> structural_cohesions(const StudyModel& model,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options) {
    std::vector<StructuralCohesion> result;
    for (const WetGroup& group : wet_groups(calibration.readings)) {
        if (group.at_failure) continue;
        const auto conditions = fitted_conditions(group, calibration, options);
        if (!conditions.empty()) {
            const Means means(model, calibration, conditions);
            const Eigen::Vector2d value = means.at(calibration.fit.parameters),
                                  error = means.errors();
            result.push_back({.liquid_content = group.liquid_content,
                              .inertial_number = group.inertial_number,
                              .rumpf = {value(0), error(0)},
                              .generalised = {value(1), error(1)}});
        }
    }
    return result;
}

}  // namespace pendular
