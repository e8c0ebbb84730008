#pragma once

#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "data/reading.h"

namespace pendular {

/// Returns the readings of a study, followed by its direct measurements, in the form that a
/// diagnosis uses. Errors of readings are estimated from replicates, separately for shear stress
/// and solid fraction; errors of direct measurements are stated in the study. Suspect measurements
/// are the readings of each condition and of each file, with a wrong factor on all shear stresses
/// and another on all solid fractions, and the direct measurements of each parameter.
Evidence evidence_of(const std::vector<Reading>& readings, const ReplicateScatter& scatter,
                     const std::vector<DirectMeasurement>& direct = {});

/// Covariates (quantities to check residuals against) that vary by more than 10 % between readings,
/// such as normal stress, inertial number or time, with a value for each entry (observable of a
/// reading, or direct measurement). (Smaller differences are scatter of set points or, for the
/// height, follow from the solid fraction.)
/// @param direct number of direct measurements, whose entries follow those of the readings and have
///        the covariate value "not a number"
std::vector<Covariate> covariates_of(const std::vector<Reading>& readings, std::size_t direct = 0);

/// Observable and condition of each entry: the shear stress and solid fraction of each reading,
/// then the direct measurements.
/// @param parameters calibrated parameters of the model, whose names the result has
/// @param direct number of direct measurements
EntryKinds entries_of(const std::vector<Reading>& readings,
                      const std::vector<Parameter>& parameters, std::size_t direct = 0);

/// Text that describes a condition, as in "300 Pa, I 0.003, liquid content 0.03".
std::string condition_text(const Condition& condition);

}  // namespace pendular
