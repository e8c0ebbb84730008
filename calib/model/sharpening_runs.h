#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "calib/model/informative_runs.h"
#include "data/reading.h"

namespace pendular {

/// Model of a study with the parameter values fitted to the readings.
struct FittedModel {
    std::shared_ptr<const EffectModel> model;
    /// Fitted parameter values, in the order of EffectModel::parameters().
    Eigen::VectorXd parameters;
    /// Covariance of the errors of the fitted `parameters`.
    Eigen::MatrixXd covariance;
};

/// Returns a task for `most_informative`: to choose the runs that most reduce the contribution of
/// simulation noise to the chi2 of all fitted models. The targets are the states of steady shear of
/// the readings in each model. Runs may be made at the target states, either with the effects of
/// each model at their fitted sizes or without effects. The states are taken at the fitted
/// parameters and at parameters shifted up and down by one standard error along the direction in
/// which the parameters are least certain, since the next fit may end at the shifted parameters.
/// The variance of each prediction has the weight 1/sigma^2, with the standard error sigma of the
/// reading.
/// @param lowest_inertial_number lowest inertial number of the runs [1], at which slower readings
///        are simulated
RunChoice sharpening_choice(const EmulatedSimulation& simulation,
                            const std::vector<FittedModel>& fitted,
                            const std::vector<Reading>& readings, double lowest_inertial_number);

}  // namespace pendular
