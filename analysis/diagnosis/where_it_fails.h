#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/misfit/checks.h"
#include "calib/model/model.h"
#include "data/recordings/replicates.h"

namespace pendular {

/// Readings of one condition or one file that deviate together from the model.
struct Offending {
    std::string readings;
    double p = 1;  ///< probability that the largest deviation arises by chance
};

/// Where a model fails on the readings of a study, beyond what its calibrated parameters can
/// imitate and what errors of the readings and of the simulation explain.
struct WhereItFails {
    Checks checks;
    std::vector<Offending> offending;  ///< deviations with p < 0.05, the smallest p first
};

/// `prediction` of the model at the calibrated `parameters`, with its slopes and the covariance
/// that the simulation causes, of the readings and of the direct measurements after them. Limits
/// are from random errors with this seed.
WhereItFails where_it_fails(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                            const Prediction& prediction, const std::vector<Parameter>& parameters,
                            const std::vector<DirectMeasurement>& direct = {},
                            std::uint64_t seed = 1);

}  // namespace pendular
