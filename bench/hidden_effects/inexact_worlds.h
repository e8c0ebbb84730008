#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

/// Options of the benchmark `inexact_worlds`, which diagnoses studies of grains that the model does
/// not describe exactly.
struct InexactWorldsOptions {
    /// Folder for the outcomes of finished studies, from which a benchmark that was stopped
    /// continues.
    std::filesystem::path work = "build/inexact-worlds";
    std::filesystem::path truths = "bench/hidden_effects/truths.csv";
    std::filesystem::path more_truths = "bench/hidden_effects/outside_truths.csv";
    std::filesystem::path states = "bench/foreign_worlds/states.csv";
    std::filesystem::path results = "bench/results";
    std::vector<std::string> only;  ///< names of the worlds to use; empty: all
    /// Beginnings of the names of the hidden truths (`Truth`) to use; empty: all.
    std::vector<std::string> hidden;
    int studies = 4;            ///< number of studies of each hidden truth in each world
    int complete_studies = 60;  ///< number of studies of each world without a hidden effect
    int threads = 1;            ///< studies side by side
};

/// Diagnoses studies whose grains differ from the model by an error of each condition that the
/// replicates share: in six worlds that differ in its size and kind: none, independent from
/// condition to condition, smooth, both, as the states of LAMMPS differ from the emulator, and as
/// those of YADE (dry) and LAMMPS (wet) do. A world is left out if its states are missing.
/// study.toml states no discrepancy. Writes inexact_worlds.txt (rates) and
/// inexact_worlds_studies.csv (one row for each study).
/// @throws InputError if a table cannot be read
/// @throws std::runtime_error if a file cannot be written
void inexact_worlds(const InexactWorldsOptions& options);

}  // namespace pendular::bench
