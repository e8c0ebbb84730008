#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/diagnosis/impact.h"
#include "analysis/misfit/checks.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the verdict in one to three sentences, such as "Missing: torque-offset (torque 0.410 +-
/// 0.030 mN m). Adding it brings chi2/dof from 9.80 to about 1.10.", with the next-best effect. If
/// no known effect explains the misfit, the text names the strongest significant trend of the
/// residuals.
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// Returns the verdict in one sentence, for a heading: the first of `verdict_line` or, where models
/// are indistinguishable, up to four of them by name.
std::string verdict_headline(const Diagnosis& diagnosis, const ModelSpace& space,
                             const Checks& checks);

/// Returns a sentence that warns of a verdict that nothing is missing where the fit is not
/// believable for other reasons (`Belief::reasons`); else empty.
std::string doubt_line(const StudyDiagnosis& diagnosis);

/// Returns a sentence with the friction coefficient [1] fitted to all readings, in the study's
/// model and in up to three models that explain the readings. Empty if the readings are doubtful: a
/// column was read in a wrong unit, or implausible readings were kept.
/// @param calibrated whether the value of `pendular calibrate` is said elsewhere
std::string friction_line(const StudyDiagnosis& diagnosis, bool calibrated = false);

/// Returns a sentence on the effect that could go undetected and would shift the friction
/// coefficient most. Empty unless the verdict is `inconclusive` and names effects.
std::string undetected_shift_line(const Diagnosis& diagnosis,
                                  const std::optional<ImpactTable>& impacts);

/// Returns sentences that add to the verdict: how similarly the effects change the readings
/// (indistinguishable), the effects that come closest (unknown), and how to obtain a firmer verdict
/// if the standard errors are assumed.
std::vector<std::string> close_effects_lines(const Diagnosis& diagnosis, const ModelSpace& space);

/// Returns sentences on a diagnosis in which known effects (the leaders) explain most of the
/// misfit, but not all of it: the relative RMS errors, the share of simulated repetitions whose
/// best model contains the leaders, and the trend that remains. Empty for any other diagnosis.
/// @param before relative RMS errors [%] of shear stress and solid fraction without the leaders
/// @param after the same with the leaders
/// @param remaining tests of the residuals of the model with the leaders
std::vector<std::string> incomplete_lines(const Diagnosis& diagnosis,
                                          const std::array<double, 2>& before,
                                          const std::array<double, 2>& after,
                                          const Checks& remaining);

}  // namespace pendular
