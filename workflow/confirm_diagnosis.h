#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Finds which physical effect is missing from a study's model, and tests this verdict by rounds of
/// new simulations. Each round makes simulations that reduce the standard errors of the best
/// models' parameters, and then repeats the diagnosis. The rounds end when the verdict is firm
/// (`Confirmation::settled`) or when the time `seconds` is used up. The user's file of simulations
/// (`SessionOptions::store`) keeps the runs. A repeated call continues with the stored runs.
/// @param seconds maximum time for simulations and diagnoses together [s]; the first diagnosis is
///        made in any case
/// @throws InputError if the study cannot be diagnosed (see `diagnose_study`)
/// @throws dem::Interrupted if the user requests a stop; the message says how to continue
StudyDiagnosis confirm_diagnosis(const ResolvedStudy& study, const Measurements& measurements,
                                 const SessionOptions& session, double seconds);

/// Returns the JSON of the simulations that tested the verdict of a diagnosis: number of runs, time
/// that runs and diagnoses took together [s], whether the verdict is firm, and the reason why the
/// verdict is not firm. Null if no simulations were requested.
nlohmann::ordered_json to_json(const std::optional<Confirmation>& confirmed);

}  // namespace pendular
