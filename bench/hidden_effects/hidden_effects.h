#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

struct HiddenEffectsOptions {
    /// Folder for simulations and for the outcomes so far.
    std::filesystem::path work = "build/hidden-effects";
    std::filesystem::path truths = "bench/hidden_effects/truths.csv";
    /// Table of earlier simulation runs, which are not simulated again.
    std::filesystem::path runs = "bench/hidden_effects/runs.csv";
    std::filesystem::path results = "bench/results";
    /// Beginnings of the names of the truths to use; empty: all truths.
    std::vector<std::string> only;
    int worlds = 1;   ///< number of simulations of each truth, with different seeds
    int studies = 4;  ///< number of studies of each truth, each with different noise
    /// Number of studies of each truth on which further measurements are made if the diagnosis
    /// cannot tell effects apart.
    int resolved_studies = 2;
    int complete_studies = 100;  ///< number of studies of the complete model, which hides no effect
    int most_measurements = 12;  ///< largest number of further measurements on a study
    int threads = 1;
    bool plan = false;     ///< whether to choose the truths again and replace the file `truths`
    bool diagnose = true;  ///< whether to diagnose the studies; false: simulate only
};

/// Simulates virtual laboratories with hidden effects, diagnoses their recordings, and reports how
/// often the diagnosis finds the hidden effects. A run that was stopped continues from its last
/// outcome.
/// @throws InputError where a table cannot be read
/// @throws std::runtime_error where a file cannot be written
/// @throws dem::Interrupted after Ctrl-C
void hidden_effects(const HiddenEffectsOptions& options);

}  // namespace pendular::bench
