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
#include "analysis/diagnosis/repeated.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/checks.h"
#include "analysis/misfit/unit_mistakes.h"
#include "analysis/proposals/propose.h"
#include "calib/model/study_models.h"
#include "workflow/fit_study.h"

namespace pendular {

/// Rival model: the study's model with other effects in place of a listed one, fitted to the
/// readings.
struct RivalModel {
    std::string in_place_of;           ///< listed effect that the model lacks
    std::vector<std::string> effects;  ///< effects that the model has instead
    Rival fitted;
    double chi2 = 0;  ///< chi2 of all entries in the fit of this model
};

/// Simulations that confirmed a diagnosis.
struct Confirmation {
    std::size_t runs = 0;  ///< number of runs that were made
    double seconds = 0;    ///< time that the confirmation took, its diagnoses included [s]
    /// Whether the verdict is firm: it stayed the same with the last runs, these agreed with the
    /// emulator, and the noise of the runs is small compared with the other errors.
    bool settled = false;
    std::string open = {};  ///< reason why the verdict is not firm; empty where it is
};

/// Number of readings up to which a diagnosis tests the readings themselves. Of more readings, it
/// tests the means of this many bins (`binned_readings`), as the time of the tests grows with the
/// third power of their number.
inline constexpr std::size_t most_tested = 200;

/// Diagnosis of a study, with the readings, models and errors on which it is based.
struct StudyDiagnosis {
    /// Readings that are tested, dry readings first: those of the study, or their means.
    std::vector<Reading> readings;
    std::size_t measured = 0;  ///< number of readings of the study
    /// The study's model with any set of candidate effects added.
    std::unique_ptr<StudyModels> models;
    Evidence evidence;    ///< readings and direct measurements with their errors
    Diagnosis diagnosis;  ///< verdict, tests and refitted models
    /// Column of the recordings that was probably read in a wrong unit, which would explain the
    /// misfit; empty: none was found.
    std::optional<UnitMistake> mistake = {};
    /// Whether a wrong measurement was found that takes precedence over the tests' verdict.
    bool overruled = false;
    /// Models that explain the readings as well, with other effects in place of a listed one.
    std::vector<RivalModel> rivals = {};
    /// Changes of unknown cause that would explain the readings, where no known effect explains
    /// them all.
    std::vector<Proposal> proposals = {};
    /// Simulations that confirmed the verdict; empty: none were requested.
    std::optional<Confirmation> confirmed = {};
    /// How often simulated repetitions of the experiment give the same verdict; empty: not
    /// computed, or no model fits the readings.
    std::optional<Repeated> repeated = {};
    Belief belief = {};  ///< judgement of the fit of the model without further effects
};

/// Tests which physical effect is missing from a study's model, with an emulator trained on the
/// runs of the atlas and of the store. Nothing is simulated.
/// @throws InputError where there are too few readings, readings at one condition only or too few
///         runs, and where a reading is outside the range that can be simulated
/// @throws dem::Interrupted where the user stops the work
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session);
/// Tests which physical effect is missing from a study's model, with an emulator trained on the
/// runs `known`. Nothing is simulated.
/// @throws InputError as the other `diagnose_study`, except for too few runs
/// @throws dem::Interrupted where the user stops the work
StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session, KnownRuns known);

/// Training runs for the diagnosis of a study, with any effect, from the atlas and the store.
/// @throws InputError where they are too few
KnownRuns runs_for_diagnosis(const ResolvedStudy& study, const SessionOptions& session);

/// Checks of the residuals: where the fitted study's model without further effects fails, beyond
/// what its calibrated parameters can imitate. `seed`: seed of the random errors from which p
/// values are computed.
Checks checks_of(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Checks of the residuals: where the refitted model with the leading effects fails (effects that
/// explain most of the misfit but not all of it); empty where the diagnosis has no leading effects.
/// `seed`: seed of the random errors from which p values are computed.
std::optional<Checks> remaining_checks(const StudyDiagnosis& diagnosis, std::uint64_t seed);

/// Impact of each effect and each error of measurement on the fitted parameters of a study's model
/// without further effects; empty where a column is in a wrong unit, as its fit means nothing then.
/// `threads`: largest number of threads.
std::optional<ImpactTable> impacts_of(const StudyDiagnosis& diagnosis, std::size_t threads);

/// Simulates `count` repetitions of the experiment (`repeat`), diagnoses each, and counts those
/// with the same verdict. Empty where no model fits the readings, and where a wrong measurement
/// took precedence over the tests.
/// @throws dem::Interrupted where the user stops the work
std::optional<Repeated> repeat_diagnosis(const StudyDiagnosis& diagnosis,
                                         const SessionOptions& session, std::size_t count);

/// Discrepancy of the model, relative to the shear stress [1], that would account for the misfit
/// that the named effects leave, or that the best refitted model leaves where none is named: the
/// `stated` discrepancy together with a further one. 0 where the model fits, no further
/// discrepancy is likely, or the misfit varies too quickly with the conditions to be one.
double remaining_discrepancy(const StudyDiagnosis& diagnosis, double stated);

/// Returns the models that fit the readings according to a diagnosis, between which the next
/// measurement should decide. If no model fits, returns the model with the leading effects or, if
/// there are none, the model without further effects. If this gives only one model, the rivals of
/// the effects that the study lists follow it.
std::vector<Rival> rivals_of(const StudyDiagnosis& diagnosis);

}  // namespace pendular
