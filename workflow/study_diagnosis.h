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
#include "analysis/diagnosis/recording_evidence.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/checks.h"
#include "analysis/misfit/odd_file.h"
#include "analysis/misfit/unit_mistakes.h"
#include "analysis/proposals/propose.h"
#include "calib/fit/stopping_rule.h"
#include "calib/model/study_model_space.h"
#include "workflow/fit_study.h"

namespace pendular {

/// Result of the simulations that tested the verdict of a diagnosis.
struct Confirmation {
    std::size_t runs = 0;  ///< number of these simulations
    double seconds = 0;    ///< time of the simulations and the diagnoses together [s]
    /// Whether the verdict is firm: the last simulations leave it unchanged and agree with the
    /// emulator, and the noise of all runs increases no standard error, of a fitted parameter or of
    /// a difference between measured and predicted value, by more than 20 %.
    bool settled = false;
    /// Reason why the verdict is not firm.
    enum class Open { nothing, no_simulation, verdict_changed, emulator_disagrees, noise };
    Open open = Open::nothing;
    Enlargement enlargement = {};  ///< largest one by the noise of the simulations
};

/// Diagnosis of a study: search for physical effects that the study's model lacks, with the
/// readings, models and errors on which the search is based.
struct StudyDiagnosis {
    std::vector<Reading> readings;  ///< tested readings (`readings_to_fit`)
    std::size_t measured = 0;       ///< number of readings before they are averaged in bins
    /// Study's model, alone and with any set of candidate effects (effects that may be added).
    std::unique_ptr<StudyModelSpace> models;
    /// Tested readings and direct measurements as one vector of values with its covariance, and the
    /// parts of the measurement that may be wrong.
    Evidence evidence;
    /// Relative standard errors [1] of stress ratio and solid fraction that the models are expected
    /// to have: those of the study, or as much more as the best explanation of a misfit leaves
    /// (`diagnose_inexact`).
    std::array<double, 2> discrepancy{};
    Diagnosis diagnosis;  ///< verdict, tests and refitted models
    /// Column of the recordings that was probably read in a wrong unit, which would explain the
    /// misfit.
    std::optional<UnitMistake> mistake = {};
    /// Models in which other effects replace a listed one and that the readings do not rule out.
    std::vector<FittedModel> rivals = {};
    /// Proposed changes of quantities, such as the torque, by an unknown cause. Each is defined by
    /// formulas and would explain at least half of the misfit. Empty if a model with known effects
    /// fits, if the verdict is overruled, or if no proposal is clearly better than the leading
    /// effects (known effects that explain most of the misfit, but not all).
    std::vector<Proposal> proposals = {};
    /// Faults inside the recordings that may explain the misfit, the largest share first.
    std::vector<RecordingEvidence> recordings = {};
    std::optional<Confirmation> confirmed = {};  ///< empty if no simulations were requested
    Belief belief = {};  ///< in the fit of the study's model, without further effects
};

/// Tests which physical effect is missing from a study's model. Nothing is simulated: an emulator,
/// trained on `runs_for_diagnosis`, predicts the readings.
/// @throws InputError if the model has at least as many parameters as there are measured values, if
///         all readings have one condition, if there are too few runs, if the study lists an effect
///         that no run has, or if a reading cannot be simulated
/// @throws dem::Interrupted if the user requests a stop
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session);
/// As above, with an emulator trained on the runs `known`.
/// @throws InputError as above, except for too few runs
/// @throws dem::Interrupted if the user requests a stop
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session, KnownRuns known);

/// Returns the runs on which a diagnosis trains its emulator: `session.training` or, if null, those
/// of atlas and store. A run may have any effect, listed in the study or not.
/// @throws InputError if atlas and store have fewer than 20 runs that can train the emulator
KnownRuns runs_for_diagnosis(const ResolvedStudy& study, const SessionOptions& session);

/// Tests where the study's fitted model, without further effects, deviates from the readings by
/// more than a change of the calibrated parameters can imitate.
/// @param seed seed of the random errors from which the p values are computed
Checks checks_of(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Tests where the model with the leading effects still deviates from the readings. Empty if the
/// diagnosis has no leading effects.
/// @param seed as for `checks_of`
std::optional<Checks> remaining_checks(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Computes by how much each effect that the model may lack, and each error of measurement, would
/// shift the fitted parameters. Empty if a column was probably read in a wrong unit
/// (`StudyDiagnosis::mistake`), since the fitted parameters are then meaningless.
std::optional<ImpactTable> impacts_of(const StudyDiagnosis& diagnosis, std::size_t threads);

/// Returns the discrepancy that study.toml would have to state so that no misfit remains: relative
/// standard error [1] of the predicted shear stress, with that of `StudyDiagnosis::discrepancy`.
/// The misfit is that of the model with the leading effects or, without leading effects, of the
/// refitted model with the smallest chi2. Returns 0 if a model fits, if no discrepancy is
/// significant, or if the misfit varies too quickly with the conditions.
double remaining_discrepancy(const StudyDiagnosis& diagnosis);

/// Returns the model that explains the readings of a diagnosis best: the study's where it does, or
/// else the one with the effects that are missing.
const FittedModel& explaining_model(const Diagnosis& diagnosis);

/// Returns the file that deviates most from that model (`odd_file`); empty where the diagnosis
/// tests means over several files.
std::optional<OddFile> odd_recording(const StudyDiagnosis& diagnosis);

}  // namespace pendular
