#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Role of an interval in a test, and why.
struct IntervalRole {
    std::string role;    ///< one of those of `roles_of`, such as "failure"
    std::string reason;  ///< such as "normal stress 0.40 times that of interval 2 before it"
};

/// Returns the role of each interval of a file: "filling", "preshear", "unloading", "failure",
/// "reloading", "steady", "wall" or "other". A role that the user or the file states takes
/// precedence. An interval whose columns show another kind of test (`kind_shown_by_columns`), or
/// without values of shear stress or of normal stress, is "other". Each row of a table of points is
/// "failure". In a file that shows shear along a wall (`shown_wall`), rows of such a table and
/// sheared intervals are "wall".
///
/// An interval is sheared if the lid turns by more than 0.01 rad or, if no interval of the file
/// shows that the lid turns, if its largest shear stress exceeds 5 % of its normal stress. Its role
/// is the first that applies:
/// - "other" if the lid turns back and forth (`turns_back_and_forth`)
/// - "other" if the lid rests and the shear never rises, as in relaxation
/// - "other" if the speed of the lid changes throughout (`varying_speed`), unless it is constant in
///   one of several steps
/// - "steady" if the normal stress is not positive, or the shear stress reaches three times it
/// - "other" if the lid turns by more than 1 rad and the load changes throughout (`load_ramp`)
/// - "other" if the lid turns by more than 1 rad in stress growth (`stress_growth`) or `stick_slip`
/// - "steady" if the lid turns by more than 1 rad
/// - "failure" if the file has only the intervals 4, 8, 12 and so on of a powder cell
/// - "failure" if the normal stress of the preceding sheared interval is more than 5 % higher
/// - "preshear" if the next sheared interval at another normal stress (by 5 %) has a lower one
/// - "failure" if the lid turns by less than 0.3 rad
/// - "other" if the load changes throughout, and in stress growth or stick-slip
/// - "steady"
///
/// Without shear, an interval is "filling" before the first sheared one, later "unloading" if its
/// normal stress is more than 5 % below that of the preceding sheared interval, else "reloading".
/// @param series in the order of the file's blocks
std::vector<IntervalRole> roles_of(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const FileFormat& format);

/// Returns the angle by which the lid turned during an interval [rad]; empty without time and
/// speed.
std::optional<double> angle_turned(const IntervalSeries& series);

/// Returns the median of the finite values, in their unit; NaN if there are none.
double median_of_known(const std::vector<double>& values);

}  // namespace pendular
