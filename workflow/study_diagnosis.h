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

/// Diagnosis of a study, with the readings, models and errors on which it is based.
struct StudyDiagnosis {
    std::vector<Reading> readings;  ///< readings of the study, dry readings first
    /// The study's model with any set of candidate effects added.
    std::unique_ptr<StudyModels> models;
    Evidence evidence;    ///< readings and direct measurements with their errors
    Diagnosis diagnosis;  ///< verdict, tests and refitted models
    /// Column of the recordings that was probably read in a wrong unit, which would explain the
    /// misfit; empty: none was found.
    std::optional<UnitMistake> mistake = {};
    Belief belief = {};  ///< judgement of the fit of the model without further effects
};

/// Tests which physical effect is missing from a study's model, with an emulator trained on the
/// runs of the atlas and of the store. Nothing is simulated.
/// @throws InputError where there are too few readings, readings at one condition only or too few
///         runs, and where a reading is outside the range that can be simulated
/// @throws dem::Interrupted where the user stops the work
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session);

/// Checks of the residuals: where the fitted study's model without further effects fails, beyond
/// what its calibrated parameters can imitate. `seed`: seed of the random errors from which p
/// values are computed.
Checks checks_of(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Checks of the residuals: where the refitted model with the leading effects fails (effects that
/// explain most of the misfit but not all of it); empty where the diagnosis has no leading effects.
/// `seed`: seed of the random errors from which p values are computed.
std::optional<Checks> remaining_checks(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// RMS errors of (shear stress, solid fraction) [%] of a prediction of the study's readings:
/// 100 sqrt(mean((predicted/measured - 1)^2)).
std::array<double, 2> rms_errors(const StudyDiagnosis& diagnosis, const Prediction& prediction);

/// Smooth error of the model, relative to the shear stress [1], that would account for the
/// residuals of the refitted model with the leading effects or, without leading effects, of the
/// refitted model with the lowest chi2 (if none was refitted, of the model as it is); 0 where a
/// model fits or no such error is likely.
double remaining_discrepancy(const StudyDiagnosis& diagnosis);

/// Returns the models that fit the readings according to a diagnosis, between which the next
/// measurement should decide. Where no model fits: the model with the leading effects, if there are
/// any, else the model without further effects.
std::vector<Rival> rivals_of(const Diagnosis& diagnosis, const StudyModels& models);

}  // namespace pendular
