#pragma once

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Turns every source of the study into readings, in run order. Readings that cannot be right are
/// set aside in `excluded`, unless the study keeps them, and are listed in `doubts` in any case.
/// @throws InputError at file:line:column for a malformed file
Measurements read_measurements(const Study& study);

}  // namespace pendular
