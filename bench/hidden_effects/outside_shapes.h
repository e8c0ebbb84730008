#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

/// Options of the benchmark `outside_shapes`, which hides effects that the program's catalogue
/// lacks.
struct OutsideShapesOptions {
    /// Folder for finished simulations and for the outcomes of finished studies, from which a
    /// benchmark that was stopped continues.
    std::filesystem::path work = "build/outside-shapes";
    /// Table of hidden truths (true friction and effects), of which only the truths with effects
    /// outside the catalogue are used.
    std::filesystem::path truths = "bench/hidden_effects/truths.csv";
    std::filesystem::path more_truths = "bench/hidden_effects/outside_truths.csv";
    std::vector<std::filesystem::path> runs = {"bench/hidden_effects/runs.csv"};
    std::filesystem::path results = "bench/results";
    /// Beginnings of the names of the hidden truths (`Truth`) to use; empty: all truths.
    std::vector<std::string> only;
    int studies = 2;  ///< number of studies of each hidden truth, each with different noise
    int threads = 1;
    /// Whether to choose the sizes of the hidden effects in the table `more_truths` again, and do
    /// nothing else.
    bool plan = false;
    bool diagnose = true;  ///< whether to diagnose the studies; false: simulate only
};

/// Simulates virtual laboratories with hidden effects that the program's catalogue lacks, and
/// diagnoses their recordings. Each diagnosis proposes which quantity changes, and along which
/// coordinate, such as the time. The benchmark writes outside_shapes.txt (how often the proposals
/// are right) and outside_shapes_studies.csv (one row for each study).
/// @throws InputError if a table cannot be read
/// @throws std::runtime_error if a file cannot be written
/// @throws dem::Interrupted after Ctrl-C
void outside_shapes(const OutsideShapesOptions& options);

}  // namespace pendular::bench
