#pragma once

#include <vector>

#include "calib/fit/fitted_model.h"
#include "calib/model/emulated_simulation.h"
#include "calib/model/informative_runs.h"
#include "data/reading.h"

namespace pendular {

/// Returns the choice of the runs that most reduce the contribution of simulation noise to the chi2
/// of the models `fitted`. The targets are the states at which each model predicts the readings:
/// with the fitted parameters, and with parameters shifted by one standard error either way along
/// their least certain direction. Runs may be made at the target states, with or without the
/// model's effects on grains. The variance of each prediction has the weight 1/sigma^2, with the
/// standard error sigma of the reading.
/// @param lowest_inertial_number [1]; slower readings are simulated at this inertial number
RunChoice sharpening_choice(const EmulatedSimulation& simulation,
                            const std::vector<FittedModel>& fitted,
                            const std::vector<Reading>& readings, double lowest_inertial_number);

}  // namespace pendular
