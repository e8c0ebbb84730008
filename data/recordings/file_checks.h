#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/recordings/findings/file_finding.h"
#include "data/recordings/interval_series.h"

namespace pendular {

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
/// rows, time that goes back, repeated rows, intervals of several tests, constants and radii of the
/// header against the columns, measured values against their set points.
std::vector<FileFinding> check_file(const BlockFile& file,
                                    const std::vector<IntervalSeries>& series,
                                    const CellFromColumns& cell);

}  // namespace pendular
