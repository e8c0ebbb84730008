#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

/// Options of the benchmark `hidden_effects`, which hides effects in virtual laboratories and
/// diagnoses their recordings.
struct HiddenEffectsOptions {
    /// Folder for finished simulations and for the outcomes of finished studies, from which a
    /// benchmark that was stopped continues.
    std::filesystem::path work = "build/hidden-effects";
    std::filesystem::path truths = "bench/hidden_effects/truths.csv";
    /// Table of earlier simulation runs, which are not simulated again. The table is read only if
    /// `work` contains no runs.
    std::filesystem::path runs = "bench/hidden_effects/runs.csv";
    std::filesystem::path results = "bench/results";
    /// Beginnings of the names of the hidden truths (`Truth`) to use; empty: all truths.
    std::vector<std::string> only;
    /// Number of simulated virtual laboratories with each hidden truth (true friction and effects),
    /// which differ in their seeds. The number is doubled for a truth that is well separated
    /// (`Truth::well_separated`), and is always ten for the complete model, which hides no effect.
    int worlds = 1;
    /// Number of studies of each hidden truth (true friction and effects), each with different
    /// noise of the instrument. The number is doubled for a truth that is well separated
    /// (`Truth::well_separated`), and is `complete_studies` for the complete model, which hides no
    /// effect.
    int studies = 4;
    /// Number of studies of each truth with one hidden effect that may continue with further
    /// measurements. A study continues if its verdict is "indistinguishable": several effects
    /// explain the readings equally well.
    int resolved_studies = 2;
    int complete_studies = 100;  ///< number of studies of the complete model, which hides no effect
    int most_measurements = 12;  ///< maximum number of additional measurements per study
    int threads = 1;
    /// Whether to choose the hidden truths again and replace the file `truths`.
    bool plan = false;
    bool diagnose = true;  ///< whether to diagnose the studies; false: simulate only
};

/// Simulates virtual laboratories with hidden effects, diagnoses their recordings, and reports how
/// often the diagnosis finds the hidden effects. A benchmark that was stopped continues after the
/// last finished study.
/// @throws InputError if a table cannot be read
/// @throws std::runtime_error if a file cannot be written
/// @throws dem::Interrupted after Ctrl-C
void hidden_effects(const HiddenEffectsOptions& options);

}  // namespace pendular::bench
