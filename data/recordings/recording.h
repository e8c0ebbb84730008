#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

/// A raw time series of an annular cell, in SI units; all vectors are of one length.
struct Recording {
    std::string file;
    std::vector<int> line;  ///< of the file, from 1
    std::vector<double> time;
    std::vector<double> torque;
    std::vector<double> normal_force;
    std::vector<double> height;
    std::vector<double> angular_velocity;
    // Redundant columns: empty where the file lacks the column, NaN where a cell is empty.
    std::vector<double> shear_stress = {};
    std::vector<double> normal_stress = {};
    std::vector<double> shear_rate = {};
    std::vector<double> interval;             ///< empty where the file has no such column
    std::vector<std::string> unused_columns;  ///< header cells that were not read

    std::size_t size() const { return time.size(); }
};

/// Rows [begin, end) of a recording at constant set points.
struct Step {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Reads a plain recording: a table with columns time, torque, normal force, gap, angular velocity
/// and, optionally, interval and the stresses and shear rate that an instrument computed, in any
/// common spelling, order and unit.
/// @throws InputError at file:line:column for what read_table and Columns refuse, a gap that is not
///         positive, and a time that goes back other than where a new interval begins
Recording read_recording(const std::filesystem::path& path);

/// Splits a recording where its interval changes; without intervals, where its angular velocity or
/// normal force comes to a level that differs by more than 5 %, and by more than its noise, from
/// the level before, both kept for at least `shortest_step` rows. What lies between two such levels
/// belongs to the later one, as its transient.
std::vector<Step> split_steps(const Recording& recording);

/// Takes out the rows that are marked.
void erase_rows(Recording& recording, const std::vector<bool>& marked);

/// Rows a step must have to be averaged.
constexpr std::size_t shortest_step = 20;

}  // namespace pendular
