#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the verdict of a diagnosis, which says which physical effect the model lacks, in one to
/// three sentences. An example is "Missing: torque-offset (torque 0.410 +- 0.030 mN m). Adding it
/// brings chi2/dof from 9.80 to about 1.10." If no known effect explains the misfit, the text names
/// the strongest significant trend of the residuals.
/// @param checks tests of the residuals of the study's model
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Returns sentences on the fit of the study's model without further effects: chi2, degrees of
/// freedom, and the p values of two tests. The first test compares the mean reading of each
/// condition with the model (lack of fit). The second test looks for a known effect, or for an
/// error in one part of the measurement (such as all readings of one file), that explains the
/// residuals.
std::string fit_line(const Diagnosis& diagnosis);

/// Returns sentences on a diagnosis in which known effects (the leading effects) explain most of
/// the misfit, but not all of it. Returns an empty list for any other diagnosis. The sentences
/// state, in this order:
/// - the relative RMS errors of the model without and with the leading effects
/// - the percentage of simulated repetitions of the experiment whose best model contains the
///   leading effects
/// - the trend that remains in the residuals
/// @param before relative RMS errors [%] without the leading effects: shear stress, then solid
///        fraction
/// @param after relative RMS errors [%] with the leading effects: shear stress, then solid fraction
/// @param remaining tests of the residuals of the model with the leading effects
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

/// Returns a sentence on a systematic error of the model that would explain a misfit without a
/// known cause. The systematic error varies smoothly with the conditions. The sentence also names
/// the setting in study.toml by which the user accepts the systematic error. Returns an empty text
/// if `size` is 0.
/// @param size standard deviation of the systematic error divided by the shear stress of the model
///        [1]
std::string discrepancy_line(double size);

/// Returns a sentence that names up to three suspect measurements with p < 0.05, the smallest p
/// first, and states how many more there are. A suspect measurement is a part of the measurement
/// that may be wrong, such as all readings of one condition. Returns an empty text if no suspect
/// measurement has p < 0.05, or if more than eight have p < 0.05.
/// @param evidence readings of the diagnosis with the names of the suspect measurements
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

/// Returns a sentence with the friction coefficient that a fit to all readings gives, with its
/// standard error: in the study's model and in up to three models that explain the readings.
/// Returns an empty text if the readings are doubtful: a column was read in a wrong unit, or
/// implausible readings were kept.
std::string friction_line(const StudyDiagnosis& diagnosis);

/// Returns sentences that add to the verdict of a diagnosis:
/// - for effects that the readings do not tell apart: how similarly the effects change the readings
/// - for missing effects: the other effect that comes closest to explaining the readings, if it
///   explains most of the misfit
/// - for a misfit that no known effect explains: the effects that come closest to explaining the
///   misfit
/// - for assumed standard errors of the readings: how to obtain a firmer verdict
std::vector<std::string> close_effects_lines(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
