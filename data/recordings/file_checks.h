#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Result of a check of a file: what is wrong with some of its rows, and what was done about it.
struct FileFinding {
    std::vector<std::pair<int, int>> lines;  ///< first and last line of each range of rows
    std::string kind;                        ///< "torque-stress", "declared-rows", "time" and so on
    std::string what;                        ///< sentence on what is wrong
    std::string done;                        ///< sentence on what the program does about it
};

/// Constants of an annular cell, from the ratios of a file's own columns.
struct CellFromColumns {
    double stress_per_torque = 0;  ///< shear stress over torque [Pa/(N m)]; 0: unknown
    double stress_per_force = 0;   ///< normal stress over normal force [1/m^2]; 0: unknown
    /// Radii [m] of a common cup with these constants; empty if none has them.
    std::optional<double> inner_radius, outer_radius;
};

/// Constants of the cell from the ratios of shear stress to torque and of normal stress to normal
/// force. If the rows show several ratios of shear stress to torque, that of the cup with the
/// file's ratio of normal stress to force decides, or else the most frequent ratio.
CellFromColumns cell_from_columns(const std::vector<IntervalSeries>& series);

/// Checks of a file of measurements by itself: torque against shear stress and normal force against
/// normal stress (ratio constant to 5 %), columns in each other's place, declared against found
/// rows, time that goes back, repeated rows, intervals of several tests, constants of the header
/// against the columns.
std::vector<FileFinding> check_file(const BlockFile& file,
                                    const std::vector<IntervalSeries>& series,
                                    const CellFromColumns& cell);

/// Adds a line to ranges of lines in rising order.
void add_line(std::vector<std::pair<int, int>>& lines, int line);

/// Lines of rows as ranges of neighbouring lines: "12-15, 20".
std::string text_of_lines(const std::vector<std::pair<int, int>>& lines, std::size_t most = 8);

}  // namespace pendular
