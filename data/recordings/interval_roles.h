#pragma once

#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Role of an interval (step of constant set points) in a test, with the reason for the choice.
struct IntervalRole {
    /// Role of the interval in the test, such as "failure". The function `roles_of` lists all
    /// roles.
    std::string role;
    /// Reason for the role of the interval, such as "normal stress 0.40 times that of interval 2
    /// before it".
    std::string reason;
};

/// Returns the role of each interval of a file: "filling", "preshear", "unloading", "failure",
/// "reloading", "steady" or "other". A role that the user or the file states takes precedence. An
/// interval without values of shear stress or of normal stress is "other".
///
/// An interval is sheared if the lid turns by more than 0.01 rad. If no interval of the file shows
/// that the lid turns, an interval is sheared if its largest shear stress exceeds 5 % of its own
/// normal stress. The role of a sheared interval is the first in the list that applies:
/// - "other", if the speed of the lid changes throughout (`speed_ramp`).
/// - "steady", if the normal stress is not positive, or if the shear stress reaches three times the
///   normal stress.
/// - "steady", if the lid turns by more than 1 rad.
/// - "failure", if the file has only the intervals 4, 8, 12 and so on of a powder cell.
/// - "failure", if the normal stress of the preceding sheared interval is more than 5 % higher.
/// - "preshear", if the next sheared interval whose normal stress differs by at least 5 % has a
///   lower normal stress.
/// - "failure", if the lid turns by less than 0.3 rad.
/// - "steady".
///
/// An interval without shear is "filling" before the first sheared interval. A later interval
/// without shear is "unloading" if its normal stress is more than 5 % lower than in the preceding
/// sheared interval, and otherwise "reloading".
/// @param series columns of each interval, in the order of the file's blocks
/// @param format settings of the user, with the roles that the user states
std::vector<IntervalRole> roles_of(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const FileFormat& format);

/// Returns the median of the finite values in a column, in the unit of the values; NaN if no value
/// is finite.
double median_of_known(const std::vector<double>& values);

}  // namespace pendular
