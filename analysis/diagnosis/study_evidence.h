#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "data/reading.h"

namespace pendular {

/// Returns the readings of a study, followed by its direct measurements, as the input of a
/// diagnosis. Errors of readings are estimated from replicates, separately for shear stress and
/// solid fraction; errors of direct measurements are stated in the study. The suspect measurements
/// are the readings of each condition and of each file, with a wrong factor on all their shear
/// stresses and another on all their solid fractions, and the direct measurements of each
/// parameter.
/// @param scatter scatter of the replicates
Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct = {});

/// Returns the quantities along which residuals are checked: normal stress, inertial number, liquid
/// content, height, time or run order, as far as they vary by more than 10 % between readings. Each
/// quantity has a value for every entry (two observables of each reading, then the direct
/// measurements). Differences of less than 10 % are scatter of set points or, for the height,
/// follow from the solid fraction.
/// @param direct number of direct measurements, for which the value is "not a number"
std::vector<Covariate> covariates_of(const std::vector<Reading>& readings, std::size_t direct = 0);

/// Returns the observable and the condition of each measured value: shear stress and solid fraction
/// of each reading in turn, then the direct measurements.
/// @param parameters calibrated parameters of the model, whose names are copied to the result
/// @param direct number of direct measurements
EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct = 0);

/// Returns a text that describes a condition, as in "300 Pa, I 0.003, liquid content 0.03" (I:
/// inertial number).
std::string condition_text(const Condition& condition);

}  // namespace pendular
