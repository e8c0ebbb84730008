#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/runs/store/run_store.h"

namespace pendular {

/// Writes simulation runs to a CSV file, one row each: the version of the solver that gave the run
/// and all `run_columns()`. Numbers have the fewest digits that read back as the same number.
/// Traces and final states are not written.
/// @throws std::runtime_error where the file cannot be written
void write_runs(const std::filesystem::path& file, const std::vector<StoredRun>& runs);

/// Returns a hash, as 16 hexadecimal digits, of the CSV row that `write_runs` writes for a run,
/// with all its inputs and results. The hash does not depend on whether the run comes from a CSV
/// file, from a store or from the simulation.
std::string run_fingerprint(const StoredRun& stored);

/// Reads runs from a CSV file with the columns that `write_runs` writes, in any order. Columns of
/// results, and the column of effects, may be missing.
/// @throws InputError for a file that cannot be read as a table, at a cell with an invalid value,
///         at a run that cannot be simulated, and at the header for an unknown or missing input
///         column
std::vector<StoredRun> read_runs(const std::filesystem::path& file);

/// Path of the atlas, the CSV file of runs that come with the program: $PENDULAR_ATLAS, else the
/// installed file, else the file in the repository. Empty where there is none.
std::filesystem::path atlas_file();

}  // namespace pendular
