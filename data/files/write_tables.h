#pragma once

#include <filesystem>

#include "data/reading.h"

namespace pendular {

/// Writes readings to a CSV file in SI units, in the format that [[readings]] of study.toml takes.
/// Each row also has the source file (relative to the written file's folder), line, step, duration
/// and number of replicates. Reading the file again gives the same readings: their errors contain
/// the scatter between replicates, which is not added again.
/// @throws std::runtime_error if the file cannot be written, on a full disk for example
void write_readings(const std::filesystem::path& path, const Measurements& measurements);

/// Writes a list of the rows of input files that make no reading (`Measurements::excluded`) to a
/// CSV file, one line per range of rows: source file, first line, last line, reason.
/// @throws std::runtime_error if the file cannot be written
void write_excluded(const std::filesystem::path& path, const Measurements& measurements);

}  // namespace pendular
