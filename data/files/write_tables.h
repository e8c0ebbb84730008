#pragma once

#include <filesystem>

#include "data/reading.h"

namespace pendular {

/// Writes readings (measured shear stresses and solid fractions with their conditions) to a CSV
/// file in SI units, in the format that an entry [[readings]] of study.toml reads. Each row also
/// has the source file (relative to the folder of the CSV file), line, step, duration and number of
/// replicates (repeated readings at one condition). The standard errors include the scatter between
/// replicates. Reading the file does not add the scatter again.
/// @throws InputError if the path is a symbolic link out of its folder
/// @throws std::runtime_error if the file cannot be written, on a full disk for example
void write_readings(const std::filesystem::path& path, const Measurements& measurements);

/// Writes the rows of the measured files that were left out (`Measurements::excluded`) to a CSV
/// file, with one line per range of rows: source file, first line, last line and reason.
/// @throws InputError if the path is a symbolic link out of its folder
/// @throws std::runtime_error if the file cannot be written
void write_excluded(const std::filesystem::path& path, const Measurements& measurements);

}  // namespace pendular
