#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "workflow/fit_study.h"
#include "workflow/next.h"
#include "workflow/study_change.h"
#include "workflow/study_diagnosis.h"
#include "workflow/study_input.h"

namespace pendular {

/// Session on a study: reads the study's files once, then calibrates, compares, predicts,
/// diagnoses, plans measurements and changes effects. It prints nothing: progress goes to
/// `SessionOptions::listener`, new simulation runs to `SessionOptions::store`. Only `calibrate`,
/// `add` and `drop` write to the results folder, only `add` and `drop` change study.toml.
class Session {
  public:
    /// Reads a study and all its recordings, and checks them before any computation. Results are
    /// written to `outputs.folder` or, if it is empty, to STUDY/out.
    /// @param study folder of the study, or its study.toml
    /// @throws InputError if a file of the study or a listed effect is wrong, if a result would
    ///         replace a file of the study, or if the study would read a result as a measurement
    explicit Session(const std::filesystem::path& study, SessionOptions options = {},
                     OutputPlaces outputs = {});
    /// Opens a session on a study that `read_input` has read. The caller must have checked that
    /// results in `folder` replace no file of the study (`protect_inputs`).
    Session(StudyInput input, SessionOptions options, std::filesystem::path folder);

    const Study& study() const { return input_.study; }
    /// Returns the study with its catalogue: built-in effects and those that study.toml defines.
    const ResolvedStudy& resolved() const { return input_.study; }
    const Measurements& measurements() const { return input_.measurements; }
    const SessionOptions& options() const { return options_; }
    const std::filesystem::path& folder() const { return folder_; }  ///< for results

    /// Fits the parameters of the study's model to the readings, and writes fit.json and
    /// fit_runs.csv to the results folder.
    /// @throws InputError if there is nothing to fit, or if a reading cannot be simulated
    /// @throws std::runtime_error if a file cannot be written
    /// @throws dem::Interrupted if the user requests a stop; the message says how to continue
    FittedStudy calibrate(const FitOptions& fit = {}) const;
    /// Compares the readings with the predictions of the fit in the results folder. Writes no file.
    /// @throws InputError if the folder has no readable fit.json, or if the study has changed since
    ///         it was fitted
    FittedStudy compare() const;
    /// Predicts readings from the fit in the results folder: shear stress [Pa] and solid fraction
    /// [1] of each condition in turn. The covariance includes errors of the fit and of the
    /// simulation.
    /// @throws InputError as `compare`, or if a condition cannot be simulated
    Prediction predict(const std::vector<Condition>& conditions) const;
    /// Tests which physical effect is missing from the study's model, and whether other effects
    /// could replace one that was added earlier (`StudyDiagnosis::rivals`).
    /// @param confirming_seconds maximum time [s] for new simulations that test the verdict and for
    ///        repeated diagnoses; empty: nothing is simulated
    /// @throws InputError if the study cannot be diagnosed (see `diagnose_study`), or if
    ///         ladder.json cannot be read
    /// @throws dem::Interrupted if the user requests a stop
    StudyDiagnosis diagnose(std::optional<double> confirming_seconds = {}) const;
    /// Plans the next measurement from a diagnosis (see `next_measurement`). The diagnosis must
    /// outlive the result.
    /// @throws InputError if none of the conditions that the instrument can measure is near an
    ///         earlier simulation run
    NextMeasurement next(const StudyDiagnosis& diagnosis) const;
    NextMeasurement next(StudyDiagnosis&& diagnosis) const = delete;
    /// Adds an effect to study.toml and fits the study before and after the change. This session
    /// then is one of the changed study. If the fit after the change does not converge, study.toml,
    /// the results and the session remain unchanged.
    /// @param effect name of a known effect, or of an effect in proposed.toml of the results folder
    /// @throws InputError if the effect cannot be added, if ladder.json cannot be read, if a fit is
    ///         impossible, or if study.toml has changed since the session read it
    /// @throws std::runtime_error if a file cannot be written
    /// @throws dem::Interrupted if the user requests a stop
    ChangedStudy add(const std::string& effect, const ChangeOptions& options = {});
    /// Removes an effect that study.toml lists, in the same way as `add` adds one.
    /// @throws InputError if the study does not list the effect; else as `add`
    /// @throws std::runtime_error if a file cannot be written
    /// @throws dem::Interrupted if the user requests a stop
    ChangedStudy drop(const std::string& effect, const ChangeOptions& options = {});

  private:
    ChangedStudy change(Action action, const std::string& effect, const ChangeOptions& options);

    SessionOptions options_;
    std::filesystem::path folder_;
    StudyInput input_;
};

}  // namespace pendular
