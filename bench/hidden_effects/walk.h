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

/// Result of a user who follows the program through one laboratory.
struct Outcome {
    std::string truth;  ///< its name
    int study = 0;      ///< number of the recordings' noise
    std::string verdict;
    bool complete = true;  ///< false: a verdict that names the effect that leads, and not all
    std::vector<std::string> named;     ///< effects that the verdict points at
    std::vector<std::string> suspects;  ///< parts of the measurement that it points at
    std::vector<std::string> faults;    ///< kinds of faults that `import` found in the recordings
    std::string confidence_set;         ///< "a | b + c"
    std::size_t set_size = 0;           ///< models in it
    bool set_has_truth = false;         ///< exactly what is hidden, or, of a complete
                                        ///< laboratory, nothing
    double chi2 = 0;                    ///< of the joint fit
    int dof = 0;
    std::optional<double> foretold_reduction,
        refitted_reduction;  ///< of chi2 by a single hidden effect

    /// The error before and after `add` of what is hidden, where it is in the confidence set.
    struct Added {
        double p = 0;                                                ///< of chi2, after
        std::array<double, 2> rms_before{}, rms_after{}, scatter{};  ///< [%]
        std::array<double, 2> noise{};                               ///< the laboratory's own [%]
        std::array<double, 2> left_out_before{}, left_out_after{};   ///< [%]
    };
    std::optional<Added> added;
    double seconds = 0;
};

/// Seed of noise of this number, which no other truth has.
std::uint64_t noise_seed(const Truth& truth, int study);

/// The files of a laboratory whose instrument has noise of this number, which no other truth has.
std::map<std::string, std::string> recordings_with_noise(LabResult laboratory, const Truth& truth,
                                                         int study);

/// RMS error of shear stress and solid fraction [%] of a model that is the truth: what the
/// instrument's noise did to these readings, which the laboratory knows, and the standard error of
/// its own runs. Works in a folder that it makes and removes.
std::array<double, 2> noise_of(const std::vector<Reading>& readings, LabResult laboratory,
                               const std::filesystem::path& folder);

/// Makes the recordings of a simulated laboratory with noise of their own, imports them, diagnoses,
/// and adds what is hidden where that is among what may be missing. Works in a folder that it makes
/// and removes. The diagnosis has the fidelity of the laboratory.
/// @param discrepancy error of the model that the study states, relative to (stress ratio, solid
///        fraction) [1]
Outcome walk(const Truth& truth, const LabResult& laboratory, int study,
             const std::filesystem::path& folder,
             const std::array<double, 2>& discrepancy = {0, 0});

/// Rows of outcomes, so that a benchmark goes on where it was stopped.
std::vector<Outcome> read_outcomes(const std::filesystem::path& file);
void write_outcomes(const std::filesystem::path& file, const std::vector<Outcome>& outcomes);

}  // namespace pendular::bench
