#pragma once

#include <optional>
#include <string_view>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Time that a text states on a clock or a stopwatch.
struct ClockTime {
    double seconds = 0;  ///< since midnight or, with a date, since 1970
    bool dated = false;
};

/// Returns the time in a text such as "14:03:07.25", "2:03:07 PM" or "2024-03-01 14:03:07", whose
/// date reads year-month-day or day.month.year; empty for other texts. A date between slashes,
/// whose order is not known, is passed over. "14:03" may be minutes and seconds, and is no time.
std::optional<ClockTime> clock_time(std::string_view text);

/// Rewrites the times of a file that are clock times as seconds since the first of them. Times
/// without a date that go back by more than half a day are of the next day. Columns of time with
/// other texts too are left alone.
void read_clock_times(BlockFile& file);

}  // namespace pendular
