#pragma once

#include "data/files/formats/block_file.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Whether a table without a time or speed has points of failure with repeats below one another:
/// exactly the same load in two to twelve rows, then another load, at three loads at least.
bool repeats_each_load(const Block& block, const IntervalSeries& series);

}  // namespace pendular
