#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/runs/store/run_store.h"

namespace pendular {

/// Writes simulation runs to a CSV file, one row per run. A row contains the version of the solver
/// and all `run_columns()`. Numbers have the fewest digits from which the exact number is read
/// back. Time series (traces) and final states are not written.
/// @throws InputError if the path is a symbolic link to a file outside of its folder
/// @throws std::runtime_error if the file cannot be written
void write_runs(const std::filesystem::path& file, const std::vector<StoredRun>& runs);

/// Returns a hash that identifies a run by its inputs and results, as 16 hexadecimal digits. The
/// hash is computed from the run's row in the CSV file that `write_runs` writes. The hash does not
/// depend on whether the run comes from a CSV file, from a store or directly from the simulation.
std::string run_fingerprint(const StoredRun& stored);

/// Reads simulation runs from a CSV file that has the columns of `write_runs`, in any order.
/// Columns of results, and the columns `effects` and `physics_version`, may be missing.
/// @throws InputError if the file cannot be read as a table, has an unknown column, lacks a column
///         of an input, or contains an invalid value or a run that cannot be simulated; the error
///         names the line
std::vector<StoredRun> read_runs(const std::filesystem::path& file);

/// Returns the path of the atlas, a CSV file of the simulation runs that come with the program. The
/// path is the value of the environment variable PENDULAR_ATLAS. If this variable is not set, the
/// path is the installed file or, if no file is installed, the file in the repository. If neither
/// file exists, the path is empty.
std::filesystem::path atlas_file();

}  // namespace pendular
