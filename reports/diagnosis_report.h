#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// Returns the verdict of a diagnosis in one to three sentences, such as which effect the study's
/// model lacks: "Missing: torque-offset (torque 0.410 +- 0.030 mN m). Adding it brings chi2/dof
/// from 9.80 to about 1.10." If no known effect explains the misfit, the text names the strongest
/// significant trend of the residuals.
/// @param checks tests of the residuals of the study's model
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Returns the power of an effect's score test (test without a refit) as text, such as "0.83". The
/// power is the probability [1] that the readings show an effect of the smallest size of interest.
/// The text is "-" if the test is significant (p < 0.05), since the power matters only for a test
/// that found no effect.
std::string power_text(const Finding& finding);

/// Returns a diagnosis's estimate of the first parameter of an effect as text, with standard error
/// and unit. The estimate comes from a refit with the effect. If no converged refit determines the
/// parameter, the estimate comes from the score test (test without a refit). An estimate at a bound
/// of the parameter has no standard error. For an effect that is on or off, the text is "switch".
/// @param finding result for the effect, an element of `diagnosis.scan`
std::string estimate_of(const Diagnosis& diagnosis, const Finding& finding,
                        const ModelSpace& space);

/// Returns the text of the change of chi2 [1] for a given reduction of chi2, such as "-686.7" for a
/// reduction of 686.7.
std::string chi2_change(double reduction);

/// Returns a table of the effects that a diagnosis tested, the effect with the largest reduction of
/// chi2 first. The first line is the heading. One line follows for each effect. The last lines
/// explain the columns.
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space);

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

/// Returns a table of the effects that the study's readings cannot exclude: an effect of the
/// smallest size of interest could be present and remain undetected. The first line is the heading.
/// One line follows for each effect, with the smallest size that these readings could detect or,
/// for an effect that is on or off, the percentage of repetitions of the study that would detect
/// the effect. Returns an empty list unless the verdict of the diagnosis is inconclusive.
/// @param effects names of the effects in the table, in the order of its lines: all names in
///        `diagnosis.effects`
std::vector<std::string> unseen_table(const Diagnosis& diagnosis, const ModelSpace& space,
                                      const std::vector<std::string>& effects);

/// Returns a sentence that names the effects that the study's readings could not detect at any size
/// within the bounds of the effect's parameter. Returns an empty text if there is no such effect,
/// or if the verdict of the diagnosis is not inconclusive.
std::string undetectable_line(const Diagnosis& diagnosis, const ModelSpace& space);

/// Returns sentences of advice after a diagnosis, such as which readings to repeat or to add. If
/// the readings do not tell which of several effects is missing, a sentence says how similarly
/// these effects change the readings. If the standard errors of the readings are assumed rather
/// than measured, a further sentence says so.
/// @param proposes whether the diagnosis proposes a change of the model, of unknown physical cause
std::vector<std::string> advice_on(const Diagnosis& diagnosis, const ModelSpace& space,
                                   bool proposes = false);

/// Returns a text that says what to do after a diagnosis: the `pendular` command to give next. For
/// the verdict suspect-measurement (an error in some readings would explain the misfit), the text
/// says to repeat these readings before the command.
/// @param study the study's name as the user gave it
/// @param proposes whether the diagnosis proposes a change of the model, of unknown physical cause
std::string next_step(const Diagnosis& diagnosis, const std::string& study, bool proposes = false);

}  // namespace pendular
