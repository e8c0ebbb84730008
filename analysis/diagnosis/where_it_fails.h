#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/misfit/checks.h"
#include "calib/model/model.h"
#include "data/recordings/replicates.h"

namespace pendular {

/// Group of readings that deviate together from a model: the readings of one condition, of one
/// file, or of one file and all later files, or the direct measurements of one effect's parameter.
struct DeviatingGroup {
    /// Name of the group of readings, such as "the readings of dry_1.csv".
    std::string readings;
    /// p value [1] of the deviation of the group's readings from the model, corrected for the
    /// number of tested groups.
    double p = 1;
};

/// Deviations of a study's readings from a model that are explained neither by a change of the
/// calibrated parameters nor by errors of readings and simulation.
struct WhereItFails {
    /// Results of the statistical tests of the residuals of the model, each with a p value.
    Checks checks;
    /// Groups of readings that deviate from the model with p < 0.05, the smallest p value first.
    std::vector<DeviatingGroup> offending;
};

/// Finds where a fitted model fails to describe the readings of a study, by statistical tests of
/// the residuals (`check_fit`) and by a test of each suspect measurement (part of the measurement
/// that may be wrong), such as the readings of one condition.
/// @param scatter scatter between replicates (readings at the same condition)
/// @param prediction prediction of the readings, then of the direct measurements, at the fitted
///        parameters, with derivatives and with the covariance of the simulation's errors
/// @param parameters calibrated parameters of the model
/// @param seed seed of the random draws of errors from which the p values follow
WhereItFails where_it_fails(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                            const Prediction& prediction, const std::vector<Parameter>& parameters,
                            const std::vector<DirectMeasurement>& direct = {},
                            std::uint64_t seed = 1);

}  // namespace pendular
