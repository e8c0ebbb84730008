#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the verdict of a diagnosis in one to three sentences, such as which effect the study's
/// model lacks: "Missing: torque-offset (torque 0.410 +- 0.030 mN m). Adding it brings chi2/dof
/// from 9.80 to about 1.10." If no known effect explains the misfit, the text names the strongest
/// significant trend of the residuals.
/// @param checks tests of the residuals of the study's model
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Returns sentences on the fit of the study's model without further effects. The sentences state
/// chi2, the degrees of freedom and the p values of two tests. The first test compares the mean
/// reading of each condition with the model (lack of fit). The second test asks whether a known
/// effect that the model lacks, or an error in one part of the measurement (such as all readings of
/// one file), explains the residuals.
std::string fit_line(const Diagnosis& diagnosis);

/// Returns sentences on a diagnosis in which known effects explain most of the misfit, but not all
/// of it. The first sentence states the relative RMS errors without and with these effects. The
/// second sentence states the percentage of simulated repetitions of the experiment in which the
/// best model contains these effects. The third sentence states the trend that remains in the
/// residuals. Returns an empty list for any other diagnosis.
/// @param before relative RMS errors [%] without the effects: first of the shear stress, second of
///        the solid fraction
/// @param after relative RMS errors [%] with the effects in the model: first of the shear stress,
///        second of the solid fraction
/// @param remaining tests of the residuals of the model with the effects
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

/// Returns a sentence on a systematic error of the model that varies smoothly with the conditions
/// and would explain the misfit that no known effect explains. The sentence also says which setting
/// in study.toml takes the systematic error into account. Returns an empty text if `size` is 0.
/// @param size standard deviation of the systematic error divided by the shear stress [1]
std::string discrepancy_line(double size);

/// Returns a sentence that names the suspect measurements with p < 0.05. A suspect measurement is a
/// part of the measurement that may be wrong, such as all readings of one condition. The sentence
/// names up to three suspect measurements, the measurement with the smallest p first, and states
/// how many more there are. Returns an empty text if no suspect measurement has p < 0.05, or if
/// more than eight have p < 0.05.
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

/// Returns a sentence with the friction coefficient that a fit to all readings gives, with its
/// standard error: in the study's model and in up to three models that explain the readings. Empty
/// if a column was read in a wrong unit, or if implausible readings were kept.
std::string friction_line(const StudyDiagnosis& diagnosis);

/// Returns sentences on effects that explain the readings nearly as well as the effects that the
/// verdict names, or that explain most of a misfit that no known effect explains. If the readings
/// do not tell which of several effects is missing, a sentence says how similarly these effects
/// change the readings. If the standard errors of the readings are assumed rather than measured, a
/// further sentence says so.
std::vector<std::string> close_effects_lines(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
