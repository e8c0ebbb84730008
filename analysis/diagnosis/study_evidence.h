#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "data/reading.h"

namespace pendular {

/// Returns the readings of a study, followed by the study's direct measurements of effects'
/// parameters, as the input of a diagnosis. Errors of readings are estimated from replicates
/// (readings at the same condition). Errors of direct measurements are stated in the study.
///
/// The suspect measurements (parts of the measurement that may be wrong) are the readings of each
/// condition, the readings of each file, and the direct measurements of each parameter. If the
/// files follow one another in time, the readings of each file but the first, taken together with
/// the readings of all later files, are also suspect. An error of suspect readings multiplies all
/// their shear stresses by one factor and all their solid fractions by another factor.
/// @param scatter estimates of the scatter between replicates, with their degrees of freedom
Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct = {});

/// Returns the quantities along which the residuals of a fit are tested: normal stress, inertial
/// number, liquid content, height, and time or run order. A quantity is returned only if its values
/// differ by more than 10 % between the readings. Each quantity has a value for the two observables
/// of each reading in turn, then for the direct measurements of effects' parameters.
/// @param direct number of direct measurements, for which the value is "not a number"
std::vector<Covariate> covariates_of(const std::vector<Reading>& readings, std::size_t direct = 0);

/// Returns the observable and the condition of each measured value: shear stress and solid fraction
/// of each reading in turn, then the direct measurements of effects' parameters.
/// @param parameters calibrated parameters of the model, whose names are copied to the result
/// @param direct number of direct measurements
EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct = 0);

/// Returns a description of a condition, such as "300 Pa, I = 0.003, liquid content 0.03" (I:
/// inertial number).
std::string condition_text(const Condition& condition);

}  // namespace pendular
