#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/lab/virtual_lab.h"

namespace pendular::bench {

/// Virtual laboratory whose grains another DEM code (LAMMPS) simulated; see
/// bench/foreign_worlds/README.md.
struct ForeignWorld {
    /// Hidden truth (true friction and effects), with the name of the virtual laboratory. The
    /// hidden effects have no parameter values.
    Truth truth;
    /// Recorded steps of constant set points, without the noise of the instrument.
    LabResult laboratory;
};

/// Reads the steady states that another DEM code (LAMMPS) simulated, and arranges the states as
/// recordings of virtual laboratories of the benchmark, one simulation for each recorded step. A
/// virtual laboratory is left out if one of its states is missing.
/// @param states bench/foreign_worlds/states.csv
/// @throws InputError if the file cannot be read, lacks a column or contains a wrong number
std::vector<ForeignWorld> read_foreign_worlds(const std::filesystem::path& states);

/// Options of the benchmark `foreign_studies`, which diagnoses studies whose flow another DEM code
/// (LAMMPS) simulated.
struct ForeignStudiesOptions {
    /// Folder for the outcomes of finished studies, from which a benchmark that was stopped
    /// continues.
    std::filesystem::path work = "build/foreign-studies";
    std::filesystem::path states = "bench/foreign_worlds/states.csv";
    std::filesystem::path results = "bench/results";
    /// Beginnings of the names of the virtual laboratories (`ForeignWorld`) to use; empty: all.
    std::vector<std::string> only;
    /// Number of studies of each virtual laboratory (`ForeignWorld`), each with different noise of
    /// the instrument.
    int studies = 20;
    /// Relative errors [1] that study.toml states for the model: first of the stress ratio, second
    /// of the solid fraction. Each study is diagnosed once without and once with these errors.
    std::array<double, 2> discrepancy = {0.005, 0.001};
};

/// Diagnoses studies whose flow another DEM code (LAMMPS) simulated. Each study is diagnosed once
/// without and once with a stated error of the model. Writes foreign_worlds.txt (summary),
/// foreign_worlds_confusion.csv (confusion matrix) and foreign_worlds_studies.csv (one row for each
/// diagnosis). A benchmark that was stopped continues after the last finished diagnosis.
/// @throws InputError if a table cannot be read
/// @throws std::runtime_error if a file cannot be written
void foreign_studies(const ForeignStudiesOptions& options);

}  // namespace pendular::bench
