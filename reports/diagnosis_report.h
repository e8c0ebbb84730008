#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// Verdict of a diagnosis (which effect the study's model lacks) as one or two sentences: "Missing:
/// torque-offset (0.410 +- 0.030 mN m). Adding it brings chi2/dof from 9.8 to about 1.1.". If no
/// known effect explains the misfit, names the strongest significant trend among `checks`.
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Table of the effects that a diagnosis tested, one line per effect, the largest reduction of chi2
/// first, below a heading and above lines that explain the columns.
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentence with chi2 and degrees of freedom of the study's model without further effects, and with
/// the p values of two tests: for lack of fit of the conditions' means, and for a missing effect.
std::string fit_line(const Diagnosis& diagnosis);

/// Sentences on a verdict that names effects which explain most of the misfit, but not all of it:
/// RMS relative errors [%] of (shear stress, solid fraction) without the effects (`before`) and
/// with them (`after`), in how many of 100 simulated repetitions another explanation would lead,
/// and the strongest trend in the checks of the model with the effects (`remaining`). Empty
/// otherwise.
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

/// Sentence on the smooth error of the model, of relative `size` in the shear stress [1], that
/// would account for the misfit that remains after a diagnosis; empty for size 0.
std::string discrepancy_line(double size);

/// Sentence that names up to three suspect measurements (conditions or files) that the model fits
/// worse than the others, with p < 0.05, the smallest p first; empty without such measurements.
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

/// Table of the effects that could be large enough to matter without showing in the study's
/// readings, one line per effect below a heading; empty unless the diagnosis' verdict is
/// inconclusive.
std::vector<std::string> unseen_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentences on the limits of a diagnosis' verdict: how similarly the effects that explain the
/// readings equally well change them, which readings to repeat or to add, and whether the standard
/// errors of the readings are assumed. `proposes`: whether the diagnosis proposes changes of
/// unknown cause.
std::vector<std::string> advice_on(const Diagnosis& diagnosis, const ModelSpace& space,
                                   bool proposes = false);

/// Text of the `pendular` command to give next, or of the measurement to repeat, after a diagnosis.
/// `study` is the study's name as the user gave it; `proposes`: whether the diagnosis proposes
/// changes of unknown cause.
std::string next_step(const Diagnosis& diagnosis, const std::string& study, bool proposes = false);

}  // namespace pendular
