#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

struct ForeignStudiesOptions {
    std::filesystem::path work = "build/foreign-studies";  ///< outcomes so far
    std::filesystem::path states = "bench/foreign_worlds/states.csv";
    std::filesystem::path results = "bench/results";
    std::vector<std::string> only;  ///< names of worlds begin with one of these; empty: all
    int studies = 20;               ///< recordings of each world, each with noise of its own
    /// Error of the model that half of the studies state, relative to (stress ratio, solid
    /// fraction) [1].
    std::array<double, 2> discrepancy = {0.005, 0.001};
};

/// Diagnoses studies of worlds that another code simulated, with and without a stated error of the
/// model, and writes foreign_worlds.txt, foreign_worlds_confusion.csv and
/// foreign_worlds_studies.csv. Goes on where it was stopped.
/// @throws InputError, std::runtime_error
void foreign_studies(const ForeignStudiesOptions& options);

}  // namespace pendular::bench
