#pragma once

#include <filesystem>
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

/// Fit of a study with its comparison to the readings.
struct CalibratedStudy {
    Calibration calibration;
    Comparison comparison;
    Belief belief;
};

/// Fit of a study from its results folder, with the model and its failures.
struct ComparedStudy {
    Calibration calibration;
    StudyModel model;
    Comparison comparison;
    WhereItFails where;
    Belief belief;
};

/// Session on a study: reads its files once, then calibrates, compares, diagnoses and plans. Long
/// work reports its progress to the listener of the options; nothing is printed. Files are written
/// by `calibrate`, `add` and `drop` alone, to the results folder and, last, to study.toml.
class Session {
  public:
    /// Reads a study, named by its folder or its study.toml, and all its recordings; what cannot be
    /// used is refused before any work. Results go to the folder of `outputs`, else to STUDY/out.
    /// @throws InputError for what is wrong in its files, its effects included, and where results
    ///         would replace or become an input
    explicit Session(const std::filesystem::path& study, SessionOptions options = {},
                     OutputPlaces outputs = {});
    /// Session on a study that was read already, with results in `folder`.
    Session(StudyInput input, SessionOptions options, std::filesystem::path folder);

    const Study& study() const { return input_.study; }
    const Measurements& measurements() const { return input_.measurements; }
    const SessionOptions& options() const { return options_; }

    /// Fits the study's parameters, and writes fit.json to the results folder.
    /// @throws InputError where there is nothing to fit; dem::Interrupted with how to go on
    CalibratedStudy calibrate(const FitOptions& fit = {}) const;
    /// Compares the fit of the results folder with the readings. `cohesion`: how lines are drawn,
    /// if not as they were.
    /// @throws InputError where there is no fit, or it is another study's
    ComparedStudy compare(const std::optional<CohesionOptions>& cohesion = {}) const;
    /// Predicts what the study's instrument shows at conditions, by the fit of the results folder:
    /// shear stresses [Pa] and solid fractions [1], with the errors of the fit and of simulation.
    /// @throws InputError as `compare`, and where a condition cannot be simulated
    Prediction predict(const std::vector<Condition>& conditions) const;
    /// Tests which physical effect is missing from the study's model.
    /// @throws InputError for what cannot be diagnosed; dem::Interrupted
    StudyDiagnosis diagnose() const;
    /// Plans the next measurement; the session and the diagnosis must live as long as the result.
    /// @throws InputError where the known runs support nothing that the rig can do
    NextMeasurement next(const StudyDiagnosis& diagnosis) const;
    NextMeasurement next(StudyDiagnosis&& diagnosis) const = delete;
    /// Adds an effect to the study's file and fits the study again; see change_study. The session
    /// then is of the study as it was: open another one.
    /// @throws InputError, besides those, where study.toml has changed since it was read
    ChangedStudy add(const std::string& effect, const FitOptions& fit = {},
                     bool same_fidelity = true) const;
    /// Removes an effect from the study's file and fits the study again.
    ChangedStudy drop(const std::string& effect, const FitOptions& fit = {},
                      bool same_fidelity = true) const;

  private:
    ChangedStudy change(Action action, const std::string& effect, const FitOptions& fit,
                        bool same_fidelity) const;

    SessionOptions options_;
    std::filesystem::path folder_;  ///< folder for results
    StudyInput input_;
};

}  // namespace pendular
