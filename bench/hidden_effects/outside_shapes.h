#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

struct OutsideShapesOptions {
    /// Folder for simulations and for the outcomes so far.
    std::filesystem::path work = "build/outside-shapes";
    /// Tables of hidden truths. Only truths with effects outside the catalogue are used.
    std::filesystem::path truths = "bench/hidden_effects/truths.csv";
    std::filesystem::path more_truths = "bench/hidden_effects/outside_truths.csv";
    std::vector<std::filesystem::path> runs = {"bench/hidden_effects/runs.csv"};
    std::filesystem::path results = "bench/results";
    /// Beginnings of the names of the truths to use; empty: all truths.
    std::vector<std::string> only;
    int studies = 2;  ///< number of studies of each truth, each with different noise
    int threads = 1;
    bool plan = false;     ///< whether to choose the sizes of the effects in `more_truths` again
    bool diagnose = true;  ///< whether to diagnose the studies; false: simulate only
};

/// Simulates virtual laboratories with hidden effects that the program's catalogue lacks, and lets
/// the diagnosis propose which quantity changes and with which condition. Writes how often such a
/// proposal is right.
/// @throws InputError where a table cannot be read
/// @throws std::runtime_error where a file cannot be written
/// @throws dem::Interrupted after Ctrl-C
void outside_shapes(const OutsideShapesOptions& options);

}  // namespace pendular::bench
