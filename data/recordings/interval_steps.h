#pragma once

#include <vector>

#include "data/recordings/interval_series.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Returns the steps of constant speed and load in an interval, as a study splits it
/// (`split_steps`). One for values that all lie within the 5 % by which steps differ, and where
/// some are unknown.
std::vector<Step> steps_of(const IntervalSeries& series);

}  // namespace pendular
