#pragma once

#include <vector>

#include "data/recordings/interval_series.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Returns the steps of constant speed and load in an interval, as a study splits it
/// (`split_steps`); one where some speeds or loads are unknown.
std::vector<Step> steps_of(const IntervalSeries& series);

}  // namespace pendular
