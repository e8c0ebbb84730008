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
    std::string readings;  ///< text, as in "the readings of dry_1.csv"
    double p = 1;          ///< p value of the deviation, corrected for the number of such tests
};

/// Failures of a model on the readings of a study: deviations that neither a change of the
/// calibrated parameters nor errors of readings and simulation explain.
struct WhereItFails {
    Checks checks;
    std::vector<Offending> offending;  ///< deviations with p < 0.05, the smallest p first
};

/// Finds where a model fails on the readings of a study.
/// @param prediction prediction of the readings, followed by the direct measurements, at the fitted
///        parameters, with derivatives and with the covariance from simulation
/// @param parameters the model's calibrated parameters
/// @param seed seed of the random errors from which the p values are computed
WhereItFails where_it_fails(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                            const Prediction& prediction, const std::vector<Parameter>& parameters,
                            const std::vector<DirectMeasurement>& direct = {},
                            std::uint64_t seed = 1);

}  // namespace pendular
