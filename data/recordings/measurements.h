#pragma once

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads all files of a study and returns the readings (measured shear stress and solid fraction at
/// each condition), in the order of the entries of study.toml. `Measurements::doubts` reports
/// physically impossible readings. Impossible readings are moved to `Measurements::excluded`,
/// unless the study keeps implausible readings.
/// @throws InputError at file:line:column if a file cannot be read, is malformed or has invalid
///         values
Measurements read_measurements(const Study& study);

}  // namespace pendular
