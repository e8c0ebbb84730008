#pragma once

#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Role of an interval (step of constant set points) in a test, with the reason for the choice.
struct IntervalRole {
    /// Role of the interval in the test, such as "failure" (names: function `interval_roles`).
    std::string role;
    /// Reason for the role, such as "normal stress 0.40 times that of interval 2 before it".
    std::string reason;
};

/// Returns the role of each interval of a file: "filling", "preshear", "unloading", "failure",
/// "reloading", "steady" or "other". Roles that the user or the file states take precedence.
/// Intervals without values of shear stress or of normal stress are "other".
///
/// A sheared interval is "steady" if the lid turns by more than 1 rad, or if the sample is hardly
/// loaded (its shear stress reaches three times the normal stress). Otherwise it is "failure" if
/// the sheared interval before it has a normal stress at least 5 % higher, if the file has only the
/// intervals 4, 8, 12 and so on of a powder cell, or if the lid turns by less than 0.3 rad, too
/// little for steady shear. It is "preshear" if the next sheared interval at another normal stress
/// has a lower one, and "steady" in all other cases. An interval without shear is "filling" before
/// the first sheared interval; later, it is "unloading" if its normal stress is at least 5 % lower
/// than that of the sheared interval before it, else "reloading".
/// @param series columns of each interval, in the order of the file's blocks
/// @param format settings of the user, with the roles that the user states
std::vector<IntervalRole> roles_of(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const FileFormat& format);

/// Returns the role that the user states for an interval, by the interval's number, its name or the
/// name of its test; empty if the user states none.
std::string stated_role(const Block& block, const FileFormat& format);

/// Median of the finite values in a column, in the unit of the values; NaN if no value is finite.
double median_of_known(const std::vector<double>& values);

}  // namespace pendular
