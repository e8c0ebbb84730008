#pragma once

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads all files of a study and converts them to readings, in the order of study.toml. Readings
/// that are physically impossible make a doubt and, unless the study keeps them, are moved to
/// `excluded`.
/// @throws InputError at file:line:column if a file cannot be read, is malformed or has invalid
///         values
Measurements read_measurements(const Study& study);

}  // namespace pendular
