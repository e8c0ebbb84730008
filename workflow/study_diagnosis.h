#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/checks.h"
#include "analysis/misfit/unit_mistakes.h"
#include "calib/model/study_models.h"
#include "workflow/fit_study.h"

namespace pendular {

/// A diagnosis with everything it was made from.
struct StudyDiagnosis {
    std::vector<Reading> readings;  ///< dry first
    std::unique_ptr<StudyModels> models;
    Evidence evidence;
    Diagnosis diagnosis;
    std::optional<UnitMistake> mistake = {};  ///< that would mend the misfit
    Belief belief = {};                       ///< in the fit of the model as it is
};

/// Diagnoses a study from the atlas and all stored runs. Nothing is simulated.
/// @throws InputError for what cannot be diagnosed; dem::Interrupted
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session);

/// Where the model as it is fails that its parameters could not take over; `seed` of the random
/// errors that set the limits.
Checks checks_of(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// The models that stand, to be told apart; where none does, the one as it is.
std::vector<Rival> rivals_of(const Diagnosis& diagnosis, const StudyModels& models);

}  // namespace pendular
