#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/misfit/checks.h"
#include "calib/model/model.h"
#include "data/recordings/measurements.h"

namespace pendular {

/// Suspect measurement that deviates from a model.
struct DeviatingGroup {
    std::string readings;  ///< such as "the readings of dry_1.csv"
    double p = 1;          ///< corrected for the number of tested groups [1]
};

/// Deviations of readings from a model that neither a change of the calibrated parameters nor
/// errors of readings and simulation explain.
struct WhereItFails {
    Checks checks;
    std::vector<DeviatingGroup> offending;  ///< those with p < 0.05, the smallest p value first
};

/// Finds where a fitted model fails to describe the readings, by `check_fit` and by a test of each
/// suspect measurement (`evidence_of`).
/// @param prediction of the readings, then of the direct measurements, at the fitted parameters,
///        with derivatives
WhereItFails where_it_fails(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                            const Prediction& prediction, const std::vector<Parameter>& parameters,
                            const std::vector<DirectMeasurement>& direct = {},
                            std::uint64_t seed = 1);

}  // namespace pendular
