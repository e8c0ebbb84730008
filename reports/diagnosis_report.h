#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// One or two sentences that say which effect the study's model lacks: "Missing: torque-offset
/// (0.410 +- 0.030 mN m). Adding it brings chi2/dof from 9.8 to about 1.1." If no known effect
/// explains the misfit, the sentence names the strongest significant trend among `checks`, the
/// tests of the residuals.
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Returns the text of an effect's first parameter as a diagnosis estimates it, with its standard
/// error and unit. The estimate comes from a refit with the effect if one converged, else from the
/// score test (linear). An estimate at a bound of the parameter has no error. For an effect that is
/// on or off, the text is "switch".
/// @param finding result for the effect, one of `diagnosis.scan`
std::string estimate_of(const Diagnosis& diagnosis, const Finding& finding,
                        const ModelSpace& space);

/// Returns the text of a reduction of chi2 [1] as a negative number: "-686.7" for a reduction of
/// 686.7.
std::string chi2_change(double reduction);

/// Table of the effects that a diagnosis tested, one line per effect, the largest reduction of chi2
/// first. The lines of effects follow a heading; lines that explain the columns come last.
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentence on the fit of the study's model without further effects: its chi2 and degrees of
/// freedom, and the p values of two tests. One tests the mean of each condition for lack of fit,
/// the other the readings for a missing effect.
std::string fit_line(const Diagnosis& diagnosis);

/// Sentences on a diagnosis that found effects which explain most of the misfit but not all of it.
/// They state the RMS errors without and with these effects, in how many of 100 simulated
/// repetitions of the experiment the best model would contain the effects, and the trend that
/// remains in the residuals. Empty for any other diagnosis.
/// @param before RMS relative errors [%] of (shear stress, solid fraction) without the effects
/// @param after RMS relative errors [%] of (shear stress, solid fraction) with the effects in the
///        model
/// @param remaining tests of the residuals of the model with the effects
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

/// Sentence that states how large an error of the model, varying smoothly with the conditions,
/// would account for the misfit which known effects leave; empty where `size` is 0.
/// @param size standard deviation of the error relative to the shear stress [1]
std::string discrepancy_line(double size);

/// Sentence that names the measurements (conditions or files) that the model fits worse than the
/// others with p < 0.05: up to three measurements, the smallest p first, and the number of the
/// others. Empty if no measurement has p < 0.05, or if more than eight do.
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

/// Table of the effects that the study's readings cannot exclude: an effect of the smallest size of
/// interest could be present and remain undetected. Below a heading, one line names the effects
/// that these readings could detect at no size; one line follows for each other effect. Empty
/// unless the verdict of the diagnosis is inconclusive.
std::vector<std::string> unseen_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentences of advice after a diagnosis: how similar the changes by indistinguishable effects are,
/// which readings to repeat or to add, and whether standard errors of readings are assumed rather
/// than measured.
/// @param proposes whether the diagnosis proposes changes of unknown cause
std::vector<std::string> advice_on(const Diagnosis& diagnosis, const ModelSpace& space,
                                   bool proposes = false);

/// Text that says what to do after a diagnosis: the `pendular` command to give next or, for a
/// suspect measurement, what to repeat.
/// @param study the study's name as the user gave it
/// @param proposes whether the diagnosis proposes changes of unknown cause
std::string next_step(const Diagnosis& diagnosis, const std::string& study, bool proposes = false);

}  // namespace pendular
