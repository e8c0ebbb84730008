#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// The verdict as one or two sentences: "Missing: torque-offset (0.41 +- 0.03 mN m). Adding it
/// brings chi2/dof from 9.8 to about 1.1.", "Something is missing that no known effect explains; it
/// grows with height."
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Table of the tested effects, one line per effect, the largest reduction of chi2 first.
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentence with chi2 and degrees of freedom of the study's model as it is, and with two
/// probabilities: of its lack of fit, and of the residuals if no known effect is missing.
std::string fit_line(const Diagnosis& diagnosis);

/// Sentences on a verdict that names effects which explain most of the misfit, but not all of it:
/// the RMS errors [%] of shear stress and solid fraction without (`before`) and with (`after`) the
/// effects, how often another explanation would lead by chance, and the strongest trend among the
/// checks of the model with the effects (`remaining`). Empty where the effects explain everything.
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

/// Sentence on a smooth error of the model, relative to the shear stress [1], that would account for
/// a remaining misfit; empty for 0.
std::string discrepancy_line(double size);

/// Sentence that names the suspect measurements, conditions or files, that deviate from the rest
/// with p < 0.05; empty without such measurements.
std::string suspects_line(const Diagnosis& diagnosis, const Evidence& evidence);

/// Table of the effects that these readings would not reveal at the smallest size of interest, one
/// line per effect below a heading; empty unless the verdict is inconclusive.
std::vector<std::string> unseen_table(const Diagnosis& diagnosis, const ModelSpace& space);

/// Sentences on the limits of the verdict: how alike rival explanations are, which readings to
/// repeat or to add, and whether the errors of the readings are assumed.
std::vector<std::string> advice_on(const Diagnosis& diagnosis, const ModelSpace& space);

/// Returns the command to give, or the measurement to make, after the verdict. `study` is the
/// study's name as the user gave it.
std::string next_step(const Diagnosis& diagnosis, const std::string& study);

}  // namespace pendular
