#pragma once

#include <string>

#include "analysis/diagnosis/diagnosis.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns chi2 and degrees of freedom of the study's model without further effects, with the p
/// values of the test for lack of fit and of the test for a known effect or a suspect measurement.
std::string fit_line(const Diagnosis& diagnosis);

/// Returns sentences on a model that counts as more inexact than expected, with chi2/dof [1] of the
/// study's model as it is with the expected error of the model. Empty if the model counts as
/// inexact as expected.
std::string granted_line(const StudyDiagnosis& diagnosis, const Study& stated);

/// Returns `granted_line`, and a sentence on up to what inexactness something is missing. Empty if
/// neither is to be said.
std::string inexactness_line(const StudyDiagnosis& diagnosis, const Study& stated);

/// Returns a sentence on the error of the model that would explain a misfit without a known cause,
/// with the setting in study.toml that accepts it. Empty if `size` is 0.
/// @param size relative standard error of the predicted shear stress [1]
/// @param of_fraction that of the solid fraction [1], which the setting repeats
std::string discrepancy_line(double size, double of_fraction);

/// Returns a sentence that names up to three suspect measurements with p < 0.05, the smallest p
/// first. Empty if none has p < 0.05, or more than eight: the model then fails as a whole.
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

}  // namespace pendular
