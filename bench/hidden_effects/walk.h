#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/lab/virtual_lab.h"
#include "workflow/study_diagnosis.h"

namespace pendular::bench {

/// Outcome of one study of a virtual laboratory: the diagnosis and, if the true model is among the
/// models that fit, the errors of the fits before and after the hidden effects are added.
struct Outcome {
    std::string truth;  ///< name of the hidden truth (true friction and effects)
    int study = 0;      ///< number of the study, which determines the noise of its recordings
    std::string verdict;
    /// Whether the study's model or a refitted model fits the readings. If no model fits and the
    /// verdict is "missing", the verdict names effects that explain most of the misfit but not all
    /// of it.
    bool complete = true;
    std::vector<std::string> named;  ///< names of the effects in the verdict
    /// Parts of the measurement whose error may explain the misfit.
    std::vector<std::string> suspects;
    /// Kinds of faults that `pendular import` found in the recordings, each listed once.
    std::vector<std::string> faults;
    /// Models that fit the readings, each given by the names of the effects added to the study's
    /// model, such as "a | b + c" for two models.
    std::string confidence_set;
    std::size_t set_size = 0;  ///< number of models that fit the readings
    /// Whether one of the models that fit the readings adds exactly the hidden effects to the
    /// study's model.
    bool set_has_truth = false;
    double chi2 = 0;  ///< chi2 of the study's model without further effects [1]
    int dof = 0;
    /// Reduction of chi2 [1] when the hidden effect is added to the model. Empty unless the truth
    /// has one hidden effect that the program knows.
    std::optional<double> predicted_reduction,  ///< reduction that the score test predicts [1]
        refitted_reduction;  ///< reduction in a refit with the effect [1]; empty: no refit

    /// Errors of the model before and after the hidden effects are added. Each array has two
    /// elements: first for the shear stress, second for the solid fraction.
    struct Added {
        /// p value [1] of chi2 of the model with the hidden effects.
        double p = 0;
        /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction
        /// (second) before and after the hidden effects are added to the model, and RMS scatter [%]
        /// of replicates (readings at the same condition) about the mean of their condition.
        std::array<double, 2> rms_before{}, rms_after{}, scatter{};
        /// Relative RMS errors [%] of the shear stress (first) and the solid fraction (second) that
        /// even the true model has (`noise_of`).
        std::array<double, 2> noise{};
        /// Relative RMS errors [%] of the shear stress (first) and the solid fraction (second) in
        /// cross-validation, which predicts each condition by a fit to the other conditions, before
        /// and after the hidden effects are added to the model.
        std::array<double, 2> left_out_before{}, left_out_after{};
    };
    std::optional<Added> added;
    /// Error of the friction coefficient of the study's model, without further effects, over its
    /// standard error [1]; empty where it was not compared.
    std::optional<double> pull;
    double seconds = 0;
};

/// Adds verdict, confidence set and tests of a diagnosis to an outcome.
void diagnose_into(Outcome& outcome, const Truth& truth, const StudyDiagnosis& found);

/// Returns the seed of the instrument's noise in study number `study` of a hidden truth (true
/// friction and effects). The seeds of different truths and studies differ.
std::uint64_t noise_seed(const Truth& truth, int study);

/// Returns the files of study number `study` of a virtual laboratory, as a map from the name of
/// each file to its text. The noise of the instrument in the recordings differs between hidden
/// truths (`truth`) and between studies.
std::map<std::string, std::string> recordings_with_noise(LabResult laboratory, const Truth& truth,
                                                         int study);

/// Returns the relative RMS errors [%] that even the true model has, first of the shear stress and
/// second of the solid fraction. The errors combine the noise of the instrument in `readings` with
/// the standard error of the laboratory's simulations.
/// @param folder folder for temporary files, which the function creates and finally removes
std::array<double, 2> noise_of(const std::vector<Reading>& readings, LabResult laboratory,
                               const std::filesystem::path& folder);

/// Carries out one study of a virtual laboratory: writes the recordings with the noise of this
/// study, imports the recordings and diagnoses the study. If the true model is among the models
/// that fit, the function also fits the study's model without and with the hidden effects. All fits
/// use the simulation settings of the laboratory.
/// @param study number of the study, which determines the noise of its recordings
/// @param folder folder for temporary files, which the function creates and finally removes
/// @param discrepancy relative errors [1] that the study states for the model: first of the stress
///        ratio, second of the solid fraction
Outcome walk(const Truth& truth, const LabResult& laboratory, int study,
             const std::filesystem::path& folder,
             const std::array<double, 2>& discrepancy = {0, 0});

/// Reads the outcomes of finished studies from a table, so that a benchmark that was stopped can
/// continue. Empty if the file does not exist.
std::vector<Outcome> read_outcomes(const std::filesystem::path& file);
void write_outcomes(const std::filesystem::path& file, const std::vector<Outcome>& outcomes);

}  // namespace pendular::bench
