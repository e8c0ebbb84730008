#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/file_format.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Raw time series of an annular shear cell. Every column up to the angular velocity is filled; a
/// cell that repeats a measured quantity may be no number.
struct Recording : IntervalSeries {
    std::string file;
    /// Number of consecutive rows of the file whose mean is one row; above 1 only for very long
    /// files (`RecordingRows`).
    int averaged_rows = 1;
    std::vector<std::string> unused_columns;  ///< header cells of columns that were not read
    std::vector<Remark> left_out =
        {};  ///< rows and intervals that were not read, and slower columns
};

/// Step of constant set points: the rows `begin` to `end` - 1 of a recording, counted from 0.
struct Step {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Returns the recording in a file of any layout that `read_blocks` knows. The columns may have any
/// common spelling, order and unit. Required are time, torque or shear stress, normal force or
/// normal stress, gap, and angular velocity or the lid's speed at the mean radius.
///
/// If the file lacks torques, normal forces or angular velocities, the column stays empty until
/// `fill_from_stresses`. `Recording::left_out` lists the intervals that lack a column, the rows
/// that lack a value, columns recorded less often than others, whose values between are on straight
/// lines at constant set points, and the intervals for which `format` states a role other than
/// steady or whose columns show another kind of test (`kind_shown_by_columns`).
/// @throws InputError at file:line:column if a required column is missing, a unit or number is
///         invalid, a gap is not positive, an interval is not a whole number, time goes back within
///         an interval, or the layout cannot be read
Recording read_recording(const std::filesystem::path& path, const FileFormat& format = {});

/// Returns the recording in a file that was read already, with the rules and errors of
/// `read_recording`.
Recording recording_of(const BlockFile& file, const FileFormat& format);

/// Computes torques from shear stresses or from forces on a lever, normal forces from normal
/// stresses, and angular velocities from speeds at the mean radius (Ri + Re)/2, where a recording
/// lacks them.
/// @throws InputError for forces on a lever if the cell states no arm
void fill_from_stresses(Recording& recording, const AnnularCell& cell);

/// Smallest number of rows that a step must have to be averaged. Chosen: fewer tell neither the end
/// of a transient nor the autocorrelation.
constexpr std::size_t shortest_step = 20;

/// Largest size of a file that `quick_recording` reads [bytes]. Chosen: the memory is bounded by
/// `most_kept_rows`, the time by this.
constexpr std::uintmax_t largest_quick_recording = std::uintmax_t(1) << 34;
/// Number of rows from which on `quick_recording` averages rows, so that the memory is bounded.
constexpr std::size_t most_kept_rows = 1 << 20;

/// Reads a plain recording row by row, in a fraction of the time and memory of `read_recording`: a
/// UTF-8 table with one header, whose other cells are all numbers with a decimal point. More than
/// `most_rows` rows are averaged (`RecordingRows`). Empty for every other file, for files larger
/// than `largest_quick_recording`, and for settings that only `read_recording` understands. Cells
/// without a number are read here only in files that `read_recording` refuses for their size.
/// @throws InputError if the file cannot be read and, in a file larger than `largest_table`, at
///         file:line:column as `read_recording`
std::optional<Recording> quick_recording(const std::filesystem::path& path,
                                         const FileFormat& format,
                                         std::size_t most_rows = most_kept_rows);

}  // namespace pendular
