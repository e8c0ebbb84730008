#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/runs/store/run_store.h"

namespace pendular {

/// Writes runs to a CSV file, one row per run: the version of the solver and all `run_columns()`.
/// Numbers have the fewest digits from which the exact number is read back. Time series and final
/// states are not written.
/// @throws InputError if the path is a symbolic link to a file outside of its folder
/// @throws std::runtime_error if the file cannot be written
void write_runs(const std::filesystem::path& file, const std::vector<StoredRun>& runs);

/// Returns a hash of a run's inputs and results as 16 hexadecimal digits. It is computed from the
/// run's row in the CSV file of `write_runs`, so that it does not depend on whether the run comes
/// from a CSV file, from a store or directly from the simulation.
std::string run_fingerprint(const StoredRun& stored);

/// Reads runs from a CSV file that has the columns of `write_runs`, in any order. Columns of
/// results, and the columns `effects` and `physics_version`, may be missing.
/// @throws InputError that names the line, if the file cannot be read as a table, has an unknown
///         column, lacks a column of an input, or contains an invalid value or a run that cannot be
///         simulated
std::vector<StoredRun> read_runs(const std::filesystem::path& file);

/// Returns the path of the atlas, a CSV file: the environment variable PENDULAR_ATLAS, else the
/// installed file, else the file in the repository; empty if there is none.
std::filesystem::path atlas_file();

}  // namespace pendular
