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
    std::shared_ptr<const EffectModel> predictor;
    /// Fit to `StudyDiagnosis::readings`. Its list of simulation runs is empty.
    Calibration calibration;
    Comparison comparison;  ///< of all readings of the diagnosis, fitted or not
    /// Second-order expansions of the predictions about the fitted parameters: `response` for all
    /// readings of the diagnosis and direct measurements, `along` for `SwitchOptions::along`.
    Response response, along;
    /// Range of each parameter around its fitted value in which `response` differs from the model's
    /// predictions by at most a tenth of the standard error of each reading.
    ParameterBounds trusted;
    /// Coefficients of chi2 of all readings and direct measurements as a quadratic form in 1, the
    /// shifts of the parameters from their fitted values, and the products of two shifts (see
    /// `chi2_form`). Gives chi2 quickly at shifted parameters.
    Eigen::MatrixXd chi2_form;
    /// Change of the fit when one reading is left out: a row for each fitted reading, with the
    /// reduction of chi2 [1] in the first column and the shift of each parameter [its unit] after
    /// it.
    Eigen::MatrixXd without_each;
};

/// Options for fitting a study with all combinations of its leading effects.
struct SwitchOptions {
    /// Largest number n of effects to switch. Up to 2^n models are fitted: with 6, a page of 60
    /// readings takes 9 s on two cores.
    std::size_t most = 6;
    std::vector<Condition> along = {};  ///< further conditions to predict, such as points of curves
};

/// Models of a study with all combinations of its leading effects, each fitted to the readings.
/// Leading are here the effects that the study lists or that the diagnosis finds most important
/// (see `switched_models`). Combination i contains effect k of `switches` if bit k of i is 1.
struct SwitchedModels {
    ResolvedStudy study;
    std::vector<std::string> switches = {};  ///< effects that are switched on and off
    /// Listed effects that all models have, since the study lists more than `SwitchOptions::most`.
    std::vector<std::string> always = {};
    std::vector<std::optional<SwitchedModel>> models = {};  ///< empty where it cannot be fitted
    /// Reason why a combination cannot be fitted, such as "the readings are impossible with these
    /// effects"; empty if it is fitted.
    std::vector<std::string> why_not = {};
    std::size_t current = 0;  ///< index of the combination that the study lists
};

/// Fits a study with each combination of its leading effects. Nothing is simulated. The leading
/// effects are the first `options.most` effects of this list:
/// - effects that the study lists;
/// - effects that the verdict names, unless the verdict is inconclusive;
/// - effects of all models that fit the readings;
/// - candidate effects with which the diagnosis refitted the model, the largest reduction of chi2
///   first;
/// - all other candidate effects, in the order of their score tests.
/// @throws dem::Interrupted if the user requests a stop
SwitchedModels switched_models(const ResolvedStudy& study, const StudyDiagnosis& diagnosis,
                               const SessionOptions& session, const SwitchOptions& options = {});

}  // namespace pendular
