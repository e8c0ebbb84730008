#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/study_model.h"
#include "workflow/fit_study.h"
#include "workflow/next.h"
#include "workflow/study_change.h"
#include "workflow/study_diagnosis.h"
#include "workflow/study_input.h"

namespace pendular {

/// Fit of a study, with its comparison with the readings and the judgement whether it can be
/// believed.
struct CalibratedStudy {
    Calibration calibration;
    Comparison comparison;
    Belief belief;
};

/// Fit of a study, read from the study's results folder, with its comparison with the readings.
struct ComparedStudy {
    Calibration calibration;
    /// Model of the study whose parameters were fitted.
    StudyModel model;
    Comparison comparison;
    /// Tests of the residuals, and the groups of readings that deviate most from the model.
    WhereItFails where;
    Belief belief;  ///< judgement whether the fit can be believed
};

/// Session on a study: reads its files once, then calibrates, compares, predicts, diagnoses, plans
/// measurements and changes effects. Long work reports its progress to the listener of the options;
/// nothing is printed. Only `calibrate`, `add` and `drop` write files: results to the results
/// folder and, last, a change of effects to study.toml.
class Session {
  public:
    /// Reads a study and all its recordings, and checks them before any work. Results will go to
    /// `outputs.folder` or, where that is empty, to STUDY/out.
    /// @param study folder of the study, or its study.toml
    /// @throws InputError where a file of the study or an effect that it lists is wrong, where a
    ///         result would replace a file of the study, and where the study would read a result as
    ///         a measurement
    explicit Session(const std::filesystem::path& study, SessionOptions options = {},
                     OutputPlaces outputs = {});
    /// Opens a session on a study that `read_input` has read. Results go to `folder`. The caller
    /// must have checked that the results replace no file of the study (`protect_inputs`).
    Session(StudyInput input, SessionOptions options, std::filesystem::path folder);

    const Study& study() const { return input_.study; }
    /// The study with its catalogue of effects: the built-in effects and those that study.toml
    /// defines.
    const ResolvedStudy& resolved() const { return input_.study; }
    const Measurements& measurements() const { return input_.measurements; }
    const SessionOptions& options() const { return options_; }

    /// Fits the parameters of the study's model to the readings, and writes fit.json and
    /// fit_runs.csv to the results folder.
    /// @throws InputError where there is nothing to fit, and where a reading cannot be simulated
    /// @throws std::runtime_error where a file cannot be written
    /// @throws dem::Interrupted where the user requests a stop; the message says how to continue
    CalibratedStudy calibrate(const FitOptions& fit = {}) const;
    /// Compares the fit in the results folder with the readings of the study. Writes no file.
    /// @param cohesion options of the cohesion lines (Mohr-Coulomb lines through wet readings);
    ///        empty: the options of the fit
    /// @throws InputError where the folder has no readable fit.json, and where the study has
    ///         changed since it was fitted
    ComparedStudy compare(const std::optional<CohesionOptions>& cohesion = {}) const;
    /// Predicts the readings of the study's instrument at some conditions from the fit in the
    /// results folder: for each condition, in order, shear stress [Pa] and solid fraction [1]. The
    /// covariance includes errors of the fit and of the simulation.
    /// @throws InputError where the folder has no readable fit.json, where the study has changed
    ///         since it was fitted, and where a condition cannot be simulated
    Prediction predict(const std::vector<Condition>& conditions) const;
    /// Tests which physical effect is missing from the study's model. If other effects could have
    /// replaced an added effect equally well, the models with these other effects are fitted too,
    /// and those that the readings do not rule out are returned as `StudyDiagnosis::rivals`.
    /// @param confirming_seconds largest time [s] for new simulations that test the verdict, and
    ///        for the diagnoses that are repeated with their results; empty: nothing is simulated
    /// @param repetitions number of repetitions of the experiment that are simulated (readings with
    ///        new random errors) and diagnosed, to count how often the verdict is the same; 0: no
    ///        repetitions
    /// @throws InputError where there are too few readings or too few earlier simulation runs,
    ///         where a reading is outside the range that can be simulated, and where ladder.json
    ///         cannot be read
    /// @throws dem::Interrupted where the user requests a stop
    StudyDiagnosis diagnose(std::optional<double> confirming_seconds = {},
                            std::size_t repetitions = 0) const;
    /// Plans the next measurement of the study from its diagnosis. The measurement tells apart the
    /// models that fit or, if only one fits, determines its parameters most precisely. The session
    /// and the diagnosis must outlive the result.
    /// @throws InputError where none of the conditions that the instrument can measure is near an
    ///         earlier simulation run
    NextMeasurement next(const StudyDiagnosis& diagnosis) const;
    NextMeasurement next(StudyDiagnosis&& diagnosis) const = delete;
    /// Adds an effect to study.toml and fits the study before and after the change. Where the fit
    /// after the change does not converge, no file is changed. This session keeps the study without
    /// the effect; open a new session for the changed study.
    /// @param effect name of a known effect, or of one in proposed.toml of the results folder
    /// @param same_fidelity whether to use the fidelity (set of simulation settings) of the fit in
    ///        the results folder, if there is one
    /// @throws InputError where the effect cannot be added, where ladder.json cannot be read, where
    ///         a fit is impossible, and where study.toml has changed since the session read it
    /// @throws std::runtime_error where a file cannot be written
    /// @throws dem::Interrupted where the user requests a stop
    ChangedStudy add(const std::string& effect, const FitOptions& fit = {},
                     bool same_fidelity = true) const;
    /// Removes an effect from study.toml and fits the study before and after the change. Where the
    /// fit after the change does not converge, no file is changed. This session keeps the study
    /// with the effect; open a new session for the changed study.
    /// @param effect name of an effect that study.toml lists
    /// @param same_fidelity whether to use the fidelity (set of simulation settings) of the fit in
    ///        the results folder, if there is one
    /// @throws InputError where the study does not list the effect, where ladder.json cannot be
    ///         read, where a fit is impossible, and where study.toml has changed since the session
    ///         read it
    /// @throws std::runtime_error where a file cannot be written
    /// @throws dem::Interrupted where the user requests a stop
    ChangedStudy drop(const std::string& effect, const FitOptions& fit = {},
                      bool same_fidelity = true) const;

  private:
    ChangedStudy change(Action action, const std::string& effect, const FitOptions& fit,
                        bool same_fidelity) const;

    SessionOptions options_;
    /// Folder to which the session writes its results.
    std::filesystem::path folder_;
    StudyInput input_;
};

}  // namespace pendular
