#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"
#include "workflow/study_change.h"

namespace pendular {

/// Returns the JSON of tests of a fit's residuals: statistic and p value of each test, and one p
/// value of all tests together.
nlohmann::ordered_json to_json(const Checks& checks);

/// Returns the JSON of the tests and of the groups of readings that deviate from the fitted model,
/// each group with its p value.
nlohmann::ordered_json to_json(const WhereItFails& where);

/// Returns the JSON of the comparison of readings and predictions.
nlohmann::ordered_json to_json(const Comparison& comparison, const std::vector<CohesionLine>& lines,
                               const WhereItFails& where);

/// Returns the JSON of a compared study, as written to compare.json.
nlohmann::ordered_json to_json(const FittedStudy& compared, const WhereItFails& where);

/// Returns the JSON of a change, as `pendular add --json` and `pendular drop --json` write it: the
/// effect, the alternatives to an added effect, the parameters and errors of the model before and
/// after the change, and the judgement on the new fit.
nlohmann::ordered_json to_json(const ChangedStudy& changed);

}  // namespace pendular
