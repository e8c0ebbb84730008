#pragma once

#include <filesystem>

#include "data/reading.h"

namespace pendular {

/// Writes readings to a CSV file in SI units, in the format that an entry [[readings]] of
/// study.toml reads. Each row also has the source file (relative to the folder of the CSV file),
/// line, step, duration and number of replicates. The standard errors include the scatter between
/// replicates, which reading the file does not add again. Where steps of a filling share a part of
/// their errors, three more columns have the number of the filling and these parts.
/// @throws as `write_whole`
void write_readings(const std::filesystem::path& path, const Measurements& measurements);

/// Writes `Measurements::excluded` to a CSV file, with one line per range of rows: source file,
/// first line, last line and reason.
/// @throws as `write_whole`
void write_excluded(const std::filesystem::path& path, const Measurements& measurements);

}  // namespace pendular
