#include "calib/structural_cohesion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calib/wet_groups.h"
#include "sim/closures/strength.h"

namespace pendular {
namespace {

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

std::vector<Condition> each_with_dry_twin(std::vector<Condition> conditions) {
    const std::size_t n = conditions.size();
    for (std::size_t k = 0; k < n; ++k) {
        conditions.push_back(conditions[k]);
        conditions.back().liquid_content = 0;
    }
    return conditions;
}

/// Mean over conditions, each wet one with its dry twin n places on.
StructuralCohesion mean_over(const std::vector<Condition>& conditions,
                             const SimulationModel& simulation, const Calibration& c) {
    const double friction = c.fit.parameters(0);
    const Prediction predicted =
        simulation.predict_conditions(c.fit.parameters, each_with_dry_twin(conditions));
    const auto n = static_cast<Eigen::Index>(conditions.size());
    const double share = 1 / static_cast<double>(n);
    StructuralCohesion mean;
    Eigen::RowVectorXd slopes = Eigen::RowVectorXd::Zero(4 * n);  // by what is predicted
    double by_coordination = 0, by_shear_stress = 0;              // by friction, through these
    for (Eigen::Index k = 0; k < n; ++k) {
        const Condition& condition = conditions[static_cast<std::size_t>(k)];
        const Eigen::Index dry = 2 * (n + k), fraction = 2 * k + 1;
        const double dry_ratio = predicted.value(dry) / condition.normal_stress;
        const double solid_fraction = predicted.value(fraction);
        const auto z = simulation.effective_coordination(friction, condition);
        const auto shear = simulation.capillary_shear_stress(friction, condition);
        using closures::reduced_cohesion;
        mean.rumpf.value += share * reduced_cohesion(dry_ratio, solid_fraction, z.value);
        mean.generalised.value +=
            share * closures::generalised_cohesion(dry_ratio, solid_fraction, z.value, shear.value);
        // A product of three: each slope is the formula with 1 in its place.
        slopes(dry) =
            share * reduced_cohesion(1, solid_fraction, z.value) / condition.normal_stress;
        slopes(fraction) = share * reduced_cohesion(dry_ratio, 1, z.value);
        by_coordination += share * reduced_cohesion(dry_ratio, solid_fraction, 1) * z.by_friction;
        by_shear_stress -= share * shear.by_friction;
    }
    const double simulated = slopes * predicted.covariance * slopes.transpose();
    const double by_friction = slopes.dot(predicted.jacobian.col(0)) + by_coordination;
    const auto error = [&](double slope) {
        return std::sqrt(simulated + slope * slope * c.fit.covariance(0, 0));
    };
    mean.rumpf.standard_error = error(by_friction);
    mean.generalised.standard_error = error(by_friction + by_shear_stress);
    return mean;
}

}  // namespace

std::vector<StructuralCohesion> structural_cohesions(const SimulationModel& simulation,
                                                     const Calibration& calibration,
                                                     const CohesionOptions& options) {
    std::vector<StructuralCohesion> result;
    for (const WetGroup& group : wet_groups(calibration.readings)) {
        const auto conditions = fitted_conditions(group, calibration, options);
        if (!conditions.empty()) {
            result.push_back(mean_over(conditions, simulation, calibration));
            result.back().liquid_content = group.liquid_content;
            result.back().inertial_number = group.inertial_number;
        }
    }
    return result;
}

}  // namespace pendular
