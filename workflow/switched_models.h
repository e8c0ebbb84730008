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

/// Model of a study with some effects switched on and all other effects switched off, fitted to the
/// readings without new simulations.
struct SwitchedModel {
    /// Predictor of readings with the effects that are switched on.
    std::shared_ptr<const EffectModel> predictor;
    /// Fit of the model, with the readings of the diagnosis (`StudyDiagnosis::readings`). The list
    /// of simulation runs (`Calibration::runs`) is empty.
    Calibration calibration;
    /// Comparison of all readings of the diagnosis, fitted or not, with the predictions of the
    /// fitted model.
    Comparison comparison;
    /// Second-order expansions of the predictions about the fitted parameters: `response` for all
    /// readings of the diagnosis and direct measurements of effects' parameters, `along` for the
    /// conditions of `SwitchOptions::along`.
    Response response, along;
    /// Range of each parameter around its fitted value in which `response` differs from the model's
    /// predictions by at most a tenth of the standard error of each reading.
    ParameterBounds trusted;
    /// Matrix that gives chi2 of all readings and direct measurements of effects' parameters
    /// quickly at shifted parameters: the coefficients of chi2 as a quadratic form in 1, the shifts
    /// of the parameters from their fitted values, and the products of two shifts (see
    /// `chi2_form`).
    Eigen::MatrixXd chi2_form;
    /// Change of the fit when one reading is left out: a row for each fitted reading, with the
    /// reduction of chi2 [1] in the first column and the shift of each parameter [its unit] in the
    /// following columns.
    Eigen::MatrixXd without_each;
};

/// Options for fitting a study with all combinations of its leading effects (effects that the study
/// lists or that the diagnosis finds most important).
struct SwitchOptions {
    /// Largest number n of effects to switch on and off; up to 2^n models are fitted.
    std::size_t most = 6;
    /// Further conditions, beside the conditions of the readings, at which the models predict, such
    /// as points of curves.
    std::vector<Condition> along = {};
};

/// Models of a study with all combinations of its leading effects (effects that the study lists or
/// that the diagnosis finds most important), each fitted to the readings.
struct SwitchedModels {
    /// Study, with the catalogue that defines the effects of the models.
    ResolvedStudy study;
    /// Names of the effects that the models switch on and off.
    std::vector<std::string> switches = {};
    /// Names of effects that the study lists and that all models have, since the study lists more
    /// effects than the largest number of effects to switch (`SwitchOptions::most`).
    std::vector<std::string> always = {};
    /// Fitted model of each combination of effects. The combination with index i contains effect k
    /// of `switches` if bit k of i is 1. An element is empty if its combination cannot be fitted.
    std::vector<std::optional<SwitchedModel>> models = {};
    /// Reason why each combination of effects cannot be fitted, such as "the readings are
    /// impossible with these effects". The reason is empty if the combination is fitted.
    std::vector<std::string> why_not = {};
    /// Index in `models` of the combination that has the effects which the study lists.
    std::size_t current = 0;
};

/// Fits a study with each combination of its leading effects. Nothing is simulated. The leading
/// effects are the first `options.most` effects of this list:
/// - effects that the study lists;
/// - effects that the verdict names, unless the verdict is inconclusive;
/// - effects of all models that fit the readings;
/// - candidate effects (effects that may be added) with which the diagnosis refitted the model, the
///   largest reduction of chi2 first;
/// - all other candidate effects, in the order of their score tests.
/// @throws dem::Interrupted if the user requests a stop
SwitchedModels switched_models(const ResolvedStudy& study, const StudyDiagnosis& diagnosis,
                               const SessionOptions& session, const SwitchOptions& options = {});

}  // namespace pendular
