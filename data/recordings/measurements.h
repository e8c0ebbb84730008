#pragma once

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Reads all files of a study and returns the readings (measured shear stress and solid fraction at
/// each condition), in the order of the entries of study.toml. Messages about readings that are
/// physically impossible are added to `Measurements::doubts`. Unless the study keeps implausible
/// readings, the impossible readings are moved to `Measurements::excluded`.
/// @throws InputError at file:line:column if a file cannot be read, is malformed or has invalid
///         values
Measurements read_measurements(const Study& study);

}  // namespace pendular
