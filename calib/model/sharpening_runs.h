#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "calib/model/informative_runs.h"
#include "data/reading.h"

namespace pendular {

/// Model with the values of its parameters that were fitted to the readings.
struct FittedModel {
    std::shared_ptr<const EffectModel> model;
    Eigen::VectorXd parameters;  ///< in the order of EffectModel::parameters()
    Eigen::MatrixXd covariance;  ///< covariance of `parameters`
};

/// Choice of the runs that reduce the noise of the runs in the chi2 of all fitted models most: runs
/// at the flow states of the readings, with each model's effects at their fitted sizes and without
/// effects. The states are taken at the fitted parameters, and at parameters shifted either way by
/// one standard error along the direction in which they are known worst, where the next fit may
/// end. The variance of each prediction has the weight 1/sigma^2, with the error sigma of the
/// reading.
/// @param lowest_inertial_number lowest inertial number of the runs [1]; slower readings are
///        simulated there
RunChoice sharpening_choice(const EmulatedSimulation& simulation,
                            const std::vector<FittedModel>& fitted,
                            const std::vector<Reading>& readings, double lowest_inertial_number);

}  // namespace pendular
