#pragma once

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Diagnoses a study, and tests the verdict by rounds of new simulations. Each round makes
/// simulations that reduce the standard errors of the best models' parameters, and repeats the
/// diagnosis. The rounds end when the verdict is firm (`Confirmation::settled`) or the time is used
/// up. `SessionOptions::store` keeps the runs, so that a repeated call continues with them.
/// @param seconds maximum time for simulations and diagnoses together [s]; the first diagnosis is
///        made in any case
/// @throws InputError if the study cannot be diagnosed (see `diagnose_study`)
/// @throws dem::Interrupted if the user requests a stop; the message says how to continue
StudyDiagnosis confirm_diagnosis(const ResolvedStudy& study, const Measurements& measurements,
                                 const SessionOptions& session, double seconds);

}  // namespace pendular
