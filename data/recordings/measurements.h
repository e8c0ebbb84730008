#pragma once

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads all files of a study and returns the readings in the order of the entries of study.toml.
/// Physically impossible readings are doubted and, unless the study keeps implausible readings,
/// excluded.
/// @throws InputError at file:line:column if a file cannot be read, is malformed or has invalid
///         values
Measurements read_measurements(const Study& study);

}  // namespace pendular
