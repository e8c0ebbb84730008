#pragma once

#include <vector>

#include "data/files/formats/block_file.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Checks of the intervals of one file, beside those of `check_file`: pure functions that return
/// what they notice.

/// Finds single values of measured columns far above all others: numbers of nines alone, as -999,
/// that are at least three times as large as any other value or alone negative, and spikes
/// (`spikes`) that exceed the 95 % quantile by half. Returns one remark for each column. None in a
/// table of points.
std::vector<Remark> far_values(const BlockFile& file);

/// Finds an interval in which the normal load returns to its largest value after each of several
/// lower ones, with less than 1 rad per step on average, as in preshear and shear to failure.
std::vector<Remark> cycles_in_one_interval(const BlockFile& file,
                                           const std::vector<IntervalSeries>& series);

}  // namespace pendular
