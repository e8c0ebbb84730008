#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Diagnoses a study as `diagnose_study` does and tests the verdict by simulations. Each round
/// simulates the states that reduce the errors of the best models most, trains the emulator on the
/// results, and repeats the diagnosis. The rounds end when the verdict is firm
/// (`Confirmation::settled`) or the time is over. All runs are kept in the session's store, so that
/// the same command continues where an earlier one ended.
/// @param seconds time that runs and diagnoses may take together [s]; the first diagnosis is made
///        in any case
/// @throws InputError where there are too few readings, readings at one condition only or too few
///         runs, and where a reading is outside the range that can be simulated
/// @throws dem::Interrupted where the user stops the work, with how to continue
StudyDiagnosis confirm_diagnosis(const ResolvedStudy& study, const Measurements& measurements,
                                 const SessionOptions& session, double seconds);

/// JSON of the simulations that confirmed a diagnosis, as `pendular diagnose --json` writes them;
/// null where none were requested.
nlohmann::ordered_json to_json(const std::optional<Confirmation>& confirmed);

}  // namespace pendular
