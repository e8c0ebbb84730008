#pragma once

#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Role of an interval in a test, with the reason why it was given this role.
struct IntervalRole {
    std::string role;    ///< one of `interval_roles`
    std::string reason;  ///< "normal stress 0.40 of that of interval 2 before it"
};

/// Roles of all intervals of a file: filling, preshear, unloading, failure, reloading, steady or
/// other. Stated roles come first. An interval in which the lid turns by more than 1 rad is steady.
/// Others have the roles that a yield-locus test shows: an interval is sheared to failure if it
/// follows a sheared interval with a normal stress at least 5 % higher, which is its preshear; if
/// only intervals 4, 8, 12, ... of a powder cell were exported; or if the lid turns by less than
/// 0.3 rad, which is no strain for steady shear. Other sheared intervals are called steady.
/// Intervals without shear are filling, unloading or reloading by their place.
std::vector<IntervalRole> roles_of(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const FileFormat& format);

/// Role that the user stated for an interval, by its number, its name or its test; empty: none.
std::string stated_role(const Block& block, const FileFormat& format);

/// Median of the finite values of a column, in its unit; NaN if there are none.
double median_of_known(const std::vector<double>& values);

}  // namespace pendular
