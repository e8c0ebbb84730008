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

/// Model of a study with some effects switched on and others off, fitted to the readings without
/// new simulations.
struct SwitchedModel {
    /// Predictor of readings with the effects that are switched on.
    std::shared_ptr<const EffectModel> predictor;
    /// Fit of the model with the readings that it uses. Its list of training runs is empty.
    Calibration calibration;
    /// Comparison of the fitted model with all readings of the study.
    Comparison comparison;
    /// Expansions of the predictions about the fitted parameters: of all readings and direct
    /// measurements, and at the conditions of `SwitchOptions::along`.
    Response response, along;
    /// Range of parameters around the fit in which `response` differs from the model by at most a
    /// tenth of the standard error of each reading.
    ParameterBounds trusted;
    /// Coefficients of chi2 of all readings as a polynomial in the shifts of the parameters from
    /// the fit.
    Eigen::MatrixXd chi2_form;
    /// Change of the fit when one fitted reading is left out, one row for each reading: the
    /// reduction of chi2 [1], then the shift of each parameter [its unit].
    Eigen::MatrixXd without_each;
};

/// Options for fitting a study with all combinations of its leading effects.
struct SwitchOptions {
    /// Largest number n of effects to switch on and off; up to 2^n models are fitted.
    std::size_t most = 6;
    /// Conditions, other than those of the readings, at which the models also predict, such as
    /// points of curves.
    std::vector<Condition> along = {};
};

/// Models of a study with all combinations of its leading effects (those that the study lists or
/// that the diagnosis finds most important), each fitted to the readings.
struct SwitchedModels {
    /// The study, with the catalogue that defines the effects of the models.
    ResolvedStudy study;
    /// Names of the effects that the models switch on and off.
    std::vector<std::string> switches = {};
    /// Names of effects that the study lists and that all models have: those beyond the largest
    /// number of switches (`SwitchOptions::most`).
    std::vector<std::string> always = {};
    /// Fitted model of each combination. The combination with index i contains effect k of
    /// `switches` if bit k of i is 1. Empty where a combination cannot be fitted.
    std::vector<std::optional<SwitchedModel>> models = {};
    /// Reason why each combination cannot be fitted, as in "the readings are impossible with these
    /// effects"; empty where it is fitted.
    std::vector<std::string> why_not = {};
    /// Index into `models` of the combination that has the effects which the study lists.
    std::size_t current = 0;
};

/// Fits a study with each combination of its leading effects: first the effects that the study
/// lists, then those that the verdict of the diagnosis names, those of other models that fit, and
/// those whose refits reduce chi2 most. Nothing is simulated.
/// @throws dem::Interrupted where the user requests a stop
SwitchedModels switched_models(const ResolvedStudy& study, const StudyDiagnosis& diagnosis,
                               const SessionOptions& session, const SwitchOptions& options = {});

}  // namespace pendular
