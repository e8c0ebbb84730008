#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pendular::bench {

struct ForeignStudiesOptions {
    /// Folder for the outcomes so far, from which a stopped run continues.
    std::filesystem::path work = "build/foreign-studies";
    std::filesystem::path states = "bench/foreign_worlds/states.csv";
    std::filesystem::path results = "bench/results";
    /// Beginnings of the names of the worlds to use; empty: all worlds.
    std::vector<std::string> only;
    int studies = 20;  ///< number of studies of each world, each with different noise
    /// Errors of the model, relative to (stress ratio, solid fraction) [1], that a study states in
    /// study.toml. Each study is diagnosed once without and once with these errors.
    std::array<double, 2> discrepancy = {0.005, 0.001};
};

/// Diagnoses studies whose flow another DEM code (LAMMPS) simulated, without and with a stated
/// error of the model, and writes foreign_worlds.txt, foreign_worlds_confusion.csv and
/// foreign_worlds_studies.csv. A run that was stopped continues from its last outcome.
/// @throws InputError where a table cannot be read
/// @throws std::runtime_error where a file cannot be written
void foreign_studies(const ForeignStudiesOptions& options);

}  // namespace pendular::bench
