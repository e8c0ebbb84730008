#pragma once

#include <string>
#include <vector>

#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns sentences on a direct measurement of an effect that may be the cause of a misfit: the
/// value to expect, as the first of `models` that contains the effect says, and the standard error
/// that decides: the change of the value by the effect over sqrt(`telling_directly`). Empty where
/// no model determines the value.
std::string value_to_expect(const StudyDiagnosis& diagnosis, const ResolvedStudy& study,
                            const Effect& effect, const std::vector<FittedModel>& models);

/// Returns a sentence on the largest standard error of a direct measurement that, entered into
/// study.toml, rules an effect out at its smallest size of interest: what the readings lack to show
/// it. Empty for an effect that is on or off.
std::string error_to_rule_out(const StudyDiagnosis& diagnosis, const ResolvedStudy& study,
                              const Effect& effect);

}  // namespace pendular
