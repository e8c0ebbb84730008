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

namespace pendular::bench {

/// Result of one study of a virtual laboratory: the diagnosis and, where the true model is among
/// those that fit, the fits before and after the hidden effects are added.
struct Outcome {
    std::string truth;  ///< name of the hidden truth
    int study = 0;      ///< number of the study, which determines the noise of its recordings
    std::string verdict;
    bool complete = true;  ///< false: the verdict names the effect that leads, and not all
    std::vector<std::string> named;     ///< names of the effects in the verdict
    std::vector<std::string> suspects;  ///< parts of the measurement that may be wrong
    /// Kinds of irregularities that import found in the recordings.
    std::vector<std::string> faults;
    std::string confidence_set;  ///< models that fit, by their effects, such as "a | b + c"
    std::size_t set_size = 0;    ///< number of models that fit
    /// Whether one of the models that fit has exactly the hidden effects.
    bool set_has_truth = false;
    double chi2 = 0;  ///< chi2 of the study's model without further effects [1]
    int dof = 0;
    /// Reduction of chi2 [1] when the hidden effect is added to the model. Empty unless the truth
    /// has one hidden effect that the program knows.
    std::optional<double> foretold_reduction,  ///< reduction that the score test predicts [1]
        refitted_reduction;  ///< reduction in a refit with the effect [1]; empty: no refit

    /// Errors of the model before and after the hidden effects are added, each for (shear stress,
    /// solid fraction) [%].
    struct Added {
        /// The p value [1] of chi2 after the effects are added.
        double p = 0;
        /// RMS errors [%] with which the model predicts the readings before and after the hidden
        /// effects are added to the model, and RMS scatter [%] of replicates about the mean of
        /// their condition. Each array has the value of the shear stress, then the value of the
        /// solid fraction.
        std::array<double, 2> rms_before{}, rms_after{}, scatter{};
        /// Errors of a model that is the truth (`noise_of`) [%].
        std::array<double, 2> noise{};
        /// RMS errors in cross-validation (each condition predicted by a fit to the other
        /// conditions) before and after the hidden effects are added [%].
        std::array<double, 2> left_out_before{}, left_out_after{};
    };
    std::optional<Added> added;
    double seconds = 0;
};

/// Seed of the instrument's noise in study number `study` of a truth. The seeds of different truths
/// and studies differ.
std::uint64_t noise_seed(const Truth& truth, int study);

/// Returns the files of a virtual laboratory's study, by name, with the noise of study number
/// `study`. The noise differs between truths and between studies.
std::map<std::string, std::string> recordings_with_noise(LabResult laboratory, const Truth& truth,
                                                         int study);

/// RMS errors of (shear stress, solid fraction) [%] that even the true model has: the noise of the
/// instrument in these readings, which is known here, combined with the standard error of the
/// laboratory's simulations.
/// @param folder folder for temporary files; created, and removed at the end
std::array<double, 2> noise_of(const std::vector<Reading>& readings, LabResult laboratory,
                               const std::filesystem::path& folder);

/// Carries out one study of a virtual laboratory: writes its recordings with the noise of this
/// study, imports and diagnoses the recordings. If the true model is among those that fit, also
/// fits the study before and after adding the hidden effects. Simulation settings are those of the
/// laboratory.
/// @param study number of the study, which determines the noise
/// @param folder folder for temporary files; created, and removed at the end
/// @param discrepancy error of the model that the study states, relative to (stress ratio, solid
///        fraction) [1]
Outcome walk(const Truth& truth, const LabResult& laboratory, int study,
             const std::filesystem::path& folder,
             const std::array<double, 2>& discrepancy = {0, 0});

/// Reads a table of outcomes, so that a benchmark which was stopped continues from its last
/// outcome. Empty where the file does not exist.
std::vector<Outcome> read_outcomes(const std::filesystem::path& file);
void write_outcomes(const std::filesystem::path& file, const std::vector<Outcome>& outcomes);

}  // namespace pendular::bench
