#pragma once

#include <array>
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

/// Diagnosis with the readings, models and errors that it rests on.
struct StudyDiagnosis {
    std::vector<Reading> readings;  ///< dry first
    std::unique_ptr<StudyModels> models;
    Evidence evidence;
    Diagnosis diagnosis;
    std::optional<UnitMistake> mistake = {};  ///< wrong unit that would explain the misfit
    Belief belief = {};                       ///< judgement of the fit without further effects
};

/// Diagnoses a study from the atlas and all stored runs. Nothing is simulated.
/// @throws InputError for what cannot be diagnosed; dem::Interrupted
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session);

/// Checks of the model without further effects, beyond what its parameters can imitate; `seed` of
/// the random errors that set the limits.
Checks checks_of(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Checks of the model with the leading effects, where the verdict names some that do not explain
/// everything; empty otherwise.
std::optional<Checks> remaining_checks(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// RMS errors of shear stress and solid fraction [%] of a prediction of the study's readings:
/// 100 sqrt(mean((predicted/measured - 1)^2)).
std::array<double, 2> rms_errors(const StudyDiagnosis& diagnosis, const Prediction& prediction);

/// Models that fit, as rivals; that of the leading effects where they do not explain everything;
/// the model without further effects where none fits.
std::vector<Rival> rivals_of(const Diagnosis& diagnosis, const StudyModels& models);

}  // namespace pendular
