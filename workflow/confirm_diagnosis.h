#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Finds which physical effect is missing from a study's model, and tests this verdict by rounds of
/// new simulations. Each round chooses flow states whose simulation reduces the standard errors of
/// the best models' parameters most, trains the emulator on the new runs, and repeats the
/// diagnosis. The rounds end when the verdict is firm (`Confirmation::settled`) or when `seconds`
/// have passed. The user's file of runs (`SessionOptions::store`) keeps all runs, so that the same
/// command continues where an earlier one ended.
/// @param seconds time that runs and diagnoses may take together [s]; the first diagnosis is made
///        in any case
/// @throws InputError where the study has too few readings, where all readings have one condition,
///         where there are too few earlier runs, and where a reading is outside the range that can
///         be simulated
/// @throws dem::Interrupted where the user requests a stop; the message says how to continue
StudyDiagnosis confirm_diagnosis(const ResolvedStudy& study, const Measurements& measurements,
                                 const SessionOptions& session, double seconds);

/// JSON of the simulations that tested the verdict of a diagnosis: their number, the time that they
/// took [s], and whether the verdict is firm or why not. Null where no simulations were requested.
nlohmann::ordered_json to_json(const std::optional<Confirmation>& confirmed);

}  // namespace pendular
