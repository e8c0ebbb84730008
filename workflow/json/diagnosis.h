#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/ladder.h"
#include "analysis/misfit/checks.h"
#include "workflow/next.h"
#include "workflow/study_change.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the names of the effects that a refitted model has beyond those of the study's model.
std::vector<std::string> names_of(const FittedModel& explanation, const ModelSpace& space);

/// Returns the JSON of an impact table. Sizes of effects and errors, and shifts of parameters, are
/// in SI units.
nlohmann::ordered_json to_json(const ImpactTable& table);

/// Sentences of a diagnosis, as the user reads them.
struct DiagnosisTexts {
    std::string verdict;                 ///< verdict in one to three sentences
    std::vector<std::string> proposals;  ///< one for each of `StudyDiagnosis::proposals`
    std::vector<std::string> to_do;      ///< what to do next, in order
    std::string open;                    ///< why the verdict is not firm; empty if it is
};

/// Returns the JSON of a diagnosis, as written to diagnosis.json: the verdict with its effects, the
/// test of each candidate effect, the refitted models, and what to do next.
/// @param checks tests of the residuals of the study's model without further effects
nlohmann::ordered_json to_json(const StudyDiagnosis& diagnosis, const Checks& checks,
                               const std::optional<ImpactTable>& impacts, const Study& study,
                               const DiagnosisTexts& texts);

/// Returns the JSON of the next measurement: the point with the predictions of each rival or, if
/// there is only one model, with the standard errors of its parameters before and after the
/// measurement.
nlohmann::ordered_json to_json(const NextMeasurement& next);

/// Returns the same with the verdict of the diagnosis and what to do next, as written to next.json.
/// @param to_do one text for each step, in order
nlohmann::ordered_json to_json(const NextMeasurement& next, const StudyDiagnosis& diagnosis,
                               const std::vector<std::string>& to_do);

/// Reads the alternatives to an effect from the result of an earlier diagnosis (`rivals_among`).
/// Empty if `file` (a diagnosis.json) cannot be read, or if the study's list of effects has changed
/// since the diagnosis.
EffectNames rivals_in(const std::filesystem::path& file, const Study& study,
                      const std::string& effect);

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
