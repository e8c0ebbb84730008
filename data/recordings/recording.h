#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"
#include "data/input_error.h"
#include "data/reading.h"

namespace pendular {

/// Raw time series of an annular shear cell, with one element per row of the file in each column.
struct Recording {
    std::string file;       ///< path of the recording's file
    std::vector<int> line;  ///< line of each row in the file, from 1
    /// Number of consecutive rows of the file whose mean is one row of the recording. The number
    /// exceeds 1 only for very long files.
    int averaged_rows = 1;
    std::vector<double> time;    ///< time of each row as recorded [s]
    std::vector<double> torque;  ///< torque on the lid in each row [N m]
    /// Normal force on the lid in each row [N], compression positive.
    std::vector<double> normal_force;
    std::vector<double> height;            ///< gap (height of the sample) in each row [m]
    std::vector<double> angular_velocity;  ///< angular velocity of the lid in each row [rad/s]
    // Redundant columns: empty if the file lacks the column, NaN where a cell is empty or no
    // number.
    /// Shear stress of each row [Pa], computed by the instrument.
    std::vector<double> shear_stress = {};
    /// Normal stress of each row [Pa], computed by the instrument.
    std::vector<double> normal_stress = {};
    /// Shear rate of each row [1/s], computed by the instrument.
    std::vector<double> shear_rate = {};
    /// Number of the step of constant set points to which each row belongs. The column is empty if
    /// the file has no step numbers.
    std::vector<double> interval;
    /// Header cells of the columns of the file that were not read.
    std::vector<std::string> unused_columns;
    /// Rows and intervals (steps of constant set points) of the file that were not read, with
    /// reasons.
    std::vector<Excluded> left_out = {};

    std::size_t size() const { return time.size(); }
};

/// Step of constant set points, as a range of rows of a recording: the rows from `begin` to `end` -
/// 1, counted from 0.
struct Step {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Reads a recording from a file. The columns may have any common spelling, order and unit. The
/// file may have any layout that `read_blocks` knows.
/// - Required columns: time, torque or shear stress, normal force or normal stress, gap, and
///   angular velocity.
/// - Optional columns: interval (number of the step), and shear stress, normal stress and shear
///   rate that the instrument computed.
///
/// If the file lacks torques or normal forces, the column of the recording stays empty until
/// `fill_from_stresses` computes the values. `Recording::left_out` lists the intervals that lack a
/// column, the rows that lack a value, and the intervals for which `format` states a role other
/// than steady.
/// @throws InputError at file:line:column if a required column is missing, a unit or number is
///         invalid, a gap is not positive, an interval is not a whole number, time goes back within
///         an interval, or the layout cannot be read
Recording read_recording(const std::filesystem::path& path, const FileFormat& format = {});

/// Returns the recording that a file contains, by the rules of `read_recording`.
/// @throws InputError at file:line:column if a required column is missing, a unit or number is
///         invalid, a gap is not positive, an interval is not a whole number, or time goes back
///         within an interval
Recording recording_of(const BlockFile& file, const FileFormat& format);

/// Computes the torque [N m] of a recording that has only shear stresses, and the normal force [N]
/// of a recording that has only normal stresses. The formulas invert the functions `shear_stress`
/// and `normal_stress`.
void fill_from_stresses(Recording& recording, const AnnularCell& cell);

/// Splits a recording into steps of constant set points, in the order of the rows. A step begins at
/// each new value in the column interval. If the recording has no column interval, a step begins at
/// each new constant value of the angular velocity or the normal force. The new value must last at
/// least `shortest_step` rows, and must differ from the old value by more than 5 % and by more than
/// the noise.
std::vector<Step> split_steps(const Recording& recording);

/// Removes the rows whose element of `marked` is true from all columns of a recording.
/// @param marked one element per row
void erase_rows(Recording& recording, const std::vector<bool>& marked);

/// Smallest number of rows that a step must have to be averaged.
constexpr std::size_t shortest_step = 20;

}  // namespace pendular
