#pragma once

#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Finds recordings that probably lost their last rows, and recordings of which no step gave a
/// reading. A recording counts as cut off if a longer file of the same entry of study.toml begins
/// with steps at the conditions of all its steps, and if it either ends there or goes on with a
/// step that gives no reading.
std::vector<Remark> incomplete_files(const Study& study, const Measurements& measurements);

}  // namespace pendular
