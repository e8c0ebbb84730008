#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/design/next_measurement.h"
#include "analysis/diagnosis/diagnosis.h"
#include "analysis/diagnosis/impact.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/checks.h"
#include "analysis/misfit/recording_evidence.h"
#include "analysis/misfit/unit_mistakes.h"
#include "analysis/proposals/propose.h"
#include "calib/model/study_models.h"
#include "workflow/fit_study.h"

namespace pendular {

/// Rival model: the study's model in which other physical effects replace one effect that the study
/// lists, fitted to the readings of the study.
struct RivalModel {
    /// Name of the effect that the study lists and that the rival model lacks.
    std::string in_place_of;
    /// Names of the effects that the rival model has in place of the effect `in_place_of`.
    std::vector<std::string> effects;
    Rival fitted;
};

/// Result of the simulations that tested the verdict of a diagnosis (which physical effect a
/// study's model lacks): whether the verdict is firm, and the effort of the test.
struct Confirmation {
    /// Number of simulation runs that were made to test the verdict.
    std::size_t runs = 0;
    double seconds = 0;  ///< time that the simulations and the diagnoses took together [s]
    /// Whether the verdict is firm. The last simulation runs must leave the verdict unchanged and
    /// agree with the predictions of the emulator, which interpolates simulations. The noise of all
    /// runs must increase no standard error, of a fitted parameter or of a difference between
    /// measured and predicted value, by more than 20 %.
    bool settled = false;
    /// Reason why the verdict is not firm. Empty if the verdict is firm.
    std::string open = {};
};

/// Diagnosis of a study: search for physical effects that the study's model lacks, with the
/// readings, models and errors on which the search is based.
struct StudyDiagnosis {
    /// Readings that are tested (`readings_to_fit`).
    std::vector<Reading> readings;
    /// Number of readings of the study, before readings are averaged in bins.
    std::size_t measured = 0;
    /// Models that were tested: the study's model, alone and with any set of candidate effects
    /// (effects that may be added).
    std::unique_ptr<StudyModels> models;
    /// Tested readings and direct measurements of effects' parameters, as one vector of values with
    /// its covariance, and the parts of the measurement that may be wrong.
    Evidence evidence;
    Diagnosis diagnosis;  ///< result of the diagnosis: verdict, tests and refitted models
    /// Column of the recordings that was probably read in a wrong unit. The wrong unit would
    /// explain the misfit. Empty if no such column was found.
    std::optional<UnitMistake> mistake = {};
    /// Rival models that the readings do not rule out: the study's model with other effects in
    /// place of one effect that the study lists.
    std::vector<RivalModel> rivals = {};
    /// Proposed changes of quantities, such as the torque, by an unknown cause. Each proposal is
    /// defined by formulas and would explain at least half of the misfit. Empty if a model with
    /// known effects fits, if the verdict is overruled, or if no proposal is clearly better than
    /// the leading effects (known effects that explain most of the misfit).
    std::vector<Proposal> proposals = {};
    /// Faults inside the recordings that may explain the misfit, the largest share first.
    std::vector<RecordingEvidence> recordings = {};
    /// Result of the simulations that tested the verdict. Empty if no simulations were requested.
    std::optional<Confirmation> confirmed = {};
    /// Judgement whether the fit of the study's model, without further effects, can be believed.
    Belief belief = {};
};

/// Tests which physical effect is missing from a study's model. Nothing is simulated: an emulator
/// predicts the readings by interpolation between earlier simulation runs. The runs come from the
/// atlas (the simulations supplied with Pendular) and from `session.store` (the user's file of
/// simulations).
/// @throws InputError if the model has at least as many parameters as there are measured values, if
///         all readings have one condition, if there are too few runs, if the study lists an effect
///         that no run has, or if a reading cannot be simulated
/// @throws dem::Interrupted if the user requests a stop
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session);
/// Tests which physical effect is missing from a study's model. Nothing is simulated: an emulator
/// predicts the readings by interpolation between the runs `known`.
/// @throws InputError if the model has at least as many parameters as there are measured values, if
///         all readings have one condition, if the study lists an effect that no run has, or if a
///         reading cannot be simulated
/// @throws dem::Interrupted if the user requests a stop
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session, KnownRuns known);

/// Returns the earlier simulation runs on which a diagnosis of the study trains its emulator, which
/// interpolates simulations. The runs come from the atlas (the simulations supplied with Pendular)
/// and from the store (the user's file of simulations). A run may have any effect, listed in the
/// study or not.
/// @throws InputError if there are fewer than 20 runs that can train the emulator
KnownRuns runs_for_diagnosis(const ResolvedStudy& study, const SessionOptions& session);

/// Tests the residuals of the study's fitted model, without further effects. The tests find where
/// the model deviates from the readings by more than a change of the calibrated parameters can
/// imitate.
/// @param seed seed of the random errors from which the p values are computed
Checks checks_of(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Tests where the model with the leading effects (effects that explain most of the misfit but not
/// all of it) still deviates from the readings. Empty if the diagnosis has no leading effects.
/// @param seed seed of the random errors from which the p values are computed
std::optional<Checks> remaining_checks(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Computes by how much each effect that the model may lack, and each error of measurement, would
/// shift the fitted parameters of a study's model. Empty if a column was probably read in a wrong
/// unit (`StudyDiagnosis::mistake`), since the fitted parameters are then meaningless.
/// @param threads largest number of threads
std::optional<ImpactTable> impacts_of(const StudyDiagnosis& diagnosis, std::size_t threads);

/// Returns the size of the discrepancy that study.toml would have to state so that no misfit
/// remains: the standard deviation [1] of an error of the predicted shear stress, relative to the
/// shear stress, that varies smoothly between conditions. The remaining misfit is the misfit of the
/// model with the leading effects (effects that explain most of the misfit) or, without leading
/// effects, of the refitted model with the smallest chi2. Returns 0 if a model fits, if no
/// discrepancy is significant, or if the misfit varies too quickly with the conditions.
/// @param stated standard deviation of the discrepancy that study.toml already states [1]; the
///        result includes this discrepancy (root of the sum of squares)
double remaining_discrepancy(const StudyDiagnosis& diagnosis, double stated);

}  // namespace pendular
