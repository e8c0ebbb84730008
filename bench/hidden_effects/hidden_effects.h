#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

struct HiddenEffectsOptions {
    std::filesystem::path work = "build/hidden-effects";  ///< simulations, and outcomes so far
    std::filesystem::path truths = "bench/hidden_effects/truths.csv";
    /// Simulations made before, which need not be made again.
    std::filesystem::path runs = "bench/hidden_effects/runs.csv";
    std::filesystem::path results = "bench/results";
    std::vector<std::string> only;  ///< names of truths begin with one of these; empty: all
    int worlds = 1;                 ///< in which each truth is simulated, with seeds of their own
    int studies = 4;                ///< recordings, each with noise of its own, of each truth
    int resolved_studies = 2;    ///< of them, on which measurements go on where effects cannot be
                                 ///< told apart
    int complete_studies = 100;  ///< of the complete model
    int most_measurements = 12;  ///< further ones
    int threads = 1;
    bool plan = false;     ///< choose the truths anew
    bool diagnose = true;  ///< likewise
};

/// Hides effects in simulated laboratories, lets the program find them, and writes what came of it.
/// Goes on where it was stopped.
/// @throws InputError, std::runtime_error; dem::Interrupted after Ctrl-C
void hidden_effects(const HiddenEffectsOptions& options);

}  // namespace pendular::bench
