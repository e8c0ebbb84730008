#pragma once

#include <filesystem>

#include "data/reading.h"

namespace pendular {

/// Writes readings as CSV in SI units, in the form [[readings]] takes, with the file (relative to
/// the folder written to), line, step, duration and replicates of each. Read back, they are the
/// same readings: the scatter between replicates is then within each one's error and is not added
/// again.
/// @throws std::runtime_error if it cannot be written, a full disk for example
void write_readings(const std::filesystem::path& path, const Measurements& measurements);

/// Writes what was left out as CSV: file, first line, last line, reason.
/// @throws std::runtime_error if it cannot be written
void write_excluded(const std::filesystem::path& path, const Measurements& measurements);

}  // namespace pendular
