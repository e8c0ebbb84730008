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

/// Returns the estimate of the first parameter of an effect with its error, as text: from a refit
/// with the effect if one converged, else the linear estimate of the score test; "switch" for an
/// effect that is on or off. An estimate without error was fitted at a bound of the parameter.
/// @param finding result for the effect, one of `diagnosis.scan`
std::string estimate_of(const Diagnosis& diagnosis, const Finding& finding,
                        const ModelSpace& space);

/// Returns the change of chi2 by a reduction as text with sign: "-686.7" for a reduction of 686.7.
std::string chi2_change(double reduction);

/// Table of the effects that a diagnosis tested, one line per effect, the largest reduction of chi2
/// first. A heading precedes the rows; lines that explain the columns follow.
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentence with chi2 and degrees of freedom of the study's model without further effects, and with
/// the p values of two tests: for lack of fit of the conditions' means, and for a missing effect.
std::string fit_line(const Diagnosis& diagnosis);

/// Sentences on a diagnosis whose effects explain most of the misfit but not all of it: RMS errors
/// without and with the effects, in how many of 100 simulated repetitions of the experiment the
/// best model would contain them, and the trend that remains. Empty for any other diagnosis.
/// @param before RMS relative errors [%] of (shear stress, solid fraction) without the effects
/// @param after RMS relative errors [%] of (shear stress, solid fraction) with the effects in the
///        model
/// @param remaining tests of the residuals of the model with the effects
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

/// Sentence on the smooth error of the model that would account for the misfit which remains after
/// a diagnosis; empty where `size` is 0.
/// @param size size of the error relative to the shear stress [1]
std::string discrepancy_line(double size);

/// Sentence that names the measurements (conditions or files) that the model fits worse than the
/// others with p < 0.05: up to three of them, the smallest p first, and the number of the others.
/// Empty if there are none, or more than eight.
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

/// Table of the effects that could have their smallest size of interest without showing in the
/// study's readings. Below a heading, it has a line with the effects that would show at no size,
/// and one line for each other effect. Empty unless the verdict of the diagnosis is inconclusive.
std::vector<std::string> unseen_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentences of advice after a diagnosis: how similarly the effects that explain the readings
/// equally well change them, which readings to repeat or to add, and whether standard errors are
/// assumed.
/// @param proposes whether the diagnosis proposes changes of unknown cause
std::vector<std::string> advice_on(const Diagnosis& diagnosis, const ModelSpace& space,
                                   bool proposes = false);

/// Text that says what to do after a diagnosis: the `pendular` command to give next or, for a
/// suspect measurement, what to repeat.
/// @param study the study's name as the user gave it
/// @param proposes whether the diagnosis proposes changes of unknown cause
std::string next_step(const Diagnosis& diagnosis, const std::string& study, bool proposes = false);

}  // namespace pendular
