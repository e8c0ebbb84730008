#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/runs/store/run_store.h"

namespace pendular {

/// Writes runs as CSV, a row each: physics_version and every one of `run_columns()`, numbers as
/// short as gives the same number back. Traces and final states are left out.
/// @throws std::runtime_error where it cannot be written
void write_runs(const std::filesystem::path& file, const std::vector<StoredRun>& runs);

/// Fingerprint of such a row, 16 hexadecimal digits: the same for the same run with the same
/// results, whether it comes from a table, from a store or from the simulation.
std::string run_fingerprint(const StoredRun& stored);

/// Reads runs back from a table. Columns may stand in any order; columns that do not determine a
/// run may be missing.
/// @throws InputError at the cell that is wrong
std::vector<StoredRun> read_runs(const std::filesystem::path& file);

/// The runs that come with the program: $PENDULAR_ATLAS, else where it is installed, else in the
/// source. Empty where there is none.
std::filesystem::path atlas_file();

}  // namespace pendular
