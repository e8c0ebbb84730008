#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Time that a text states on a clock or a stopwatch.
struct ClockTime {
    double seconds = 0;  ///< since midnight or, with a date, since 1970
    bool dated = false;
    std::string date = {};  ///< between slashes, whose order is not known; empty: none
};

/// Returns the time in a text such as "14:03:07.25", "2:03:07 PM" or "2024-03-01 14:03:07", whose
/// date reads year-month-day or day.month.year; empty for other texts. A date between slashes,
/// whose order is not known, is kept apart. "14:03" may be minutes and seconds, and is no time.
std::optional<ClockTime> clock_time(std::string_view text);

/// Rewrites the times of a file that are clock times as seconds since the first of them. Times
/// without a date that go back by more than half a day are of the next day. Dates between slashes
/// count where they change. Columns of time with
/// other texts too are left alone.
/// @throws InputError at a date between slashes that is another day in the order day/month than in
///         month/day, if no date of the file tells which it is
void read_clock_times(BlockFile& file);

}  // namespace pendular
