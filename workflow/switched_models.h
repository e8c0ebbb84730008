#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "calib/model/effect_model.h"
#include "calib/model/response.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Model of a study with some of its switchable effects on and the others off, fitted as `pendular
/// add` fits it without new simulations.
struct SwitchedModel {
    std::shared_ptr<const EffectModel> predictor;
    /// Fit of the model, with the readings that it uses. Has no training runs.
    Calibration calibration;
    Comparison comparison;  ///< comparison of the fit with all readings
    /// Predictions of all readings and direct measurements, and of the conditions of
    /// `SwitchOptions::along`, as the parameters move from the fit.
    Response response, along;
    /// Range around the fit in which `response` differs from the model by at most a tenth of the
    /// standard error of each reading.
    ParameterBounds trusted;
    Eigen::MatrixXd chi2_form;  ///< chi2 of all readings as the parameters move (`chi2_form`)
    /// Fall of chi2 [1] and shifts of the parameters when a fitted reading is left out, a row for
    /// each (`without_each`).
    Eigen::MatrixXd without_each;
};

/// Options of `switched_models`.
struct SwitchOptions {
    std::size_t most = 6;  ///< largest number of switches; 2^most models are fitted
    /// Further conditions to predict, such as points of curves.
    std::vector<Condition> along = {};
};

/// All combinations of the leading effects of a study, each fitted to its readings.
struct SwitchedModels {
    ResolvedStudy study;                     ///< the study, whose catalogue the models use
    std::vector<std::string> switches = {};  ///< names of the effects to switch on and off
    std::vector<std::string> always = {};  ///< effects that the study lists and that have no switch
    /// The combinations: in the one with index i, switch k is on where bit k of i is set. Empty
    /// where they cannot be fitted.
    std::vector<std::optional<SwitchedModel>> models = {};
    /// Reason why each combination cannot be fitted, as in "the readings are impossible with ...";
    /// empty where it can.
    std::vector<std::string> why_not = {};
    std::size_t current = 0;  ///< index of the combination that the study lists
};

/// Fits a study with each combination of its leading effects: those that the study lists, then
/// those that the verdict names, those of other models that fit, and those whose refits reduce chi2
/// most. Nothing is simulated.
/// @throws dem::Interrupted where the user stops the work
SwitchedModels switched_models(const ResolvedStudy& study, const StudyDiagnosis& diagnosis,
                               const SessionOptions& session, const SwitchOptions& options = {});

}  // namespace pendular
