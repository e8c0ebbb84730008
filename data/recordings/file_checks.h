#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/recordings/findings/file_finding.h"
#include "data/recordings/interval_series.h"

namespace pendular {

/// Constants with which an instrument converts torque and normal force to stresses in an annular
/// cell, deduced from the columns of a file.
struct CellFromColumns {
    /// Ratio of shear stress to torque in the columns of the file [Pa/(N m)]; 0: unknown.
    double stress_per_torque = 0;
    /// Ratio of normal stress to normal force in the columns of the file [1/m^2]; 0: unknown.
    double stress_per_force = 0;
    /// Inner and outer radius [m] of the commercial cup that has the file's ratios of stress to
    /// torque and to normal force; empty if no known cup has the ratios.
    std::optional<double> inner_radius, outer_radius;
};

/// Returns the constants of the cell from the most frequent ratios of shear stress to torque and of
/// normal stress to normal force in the rows of a file. If a commercial cup has the ratios in the
/// file, the radii of the cup are returned too; one ratio is enough if the file gives only one. If
/// the ratio of normal stress to normal force is that of a cup, but only some rows have the cup's
/// ratio of shear stress to torque, the cup's ratio of shear stress to torque is returned.
/// @param series columns of each interval of the file
CellFromColumns cell_from_columns(const std::vector<IntervalSeries>& series);

/// Checks a file of measurements for contradictions within the file, and returns one finding for
/// each kind of contradiction. The kinds are: ratio of shear stress to torque or of normal stress
/// to normal force not constant to 5 %, two columns with exchanged headers, declared number of rows
/// not found, time that goes back, repeated rows, several tests in one file, constants or radii in
/// the header that contradict the columns, and measured values that do not follow their set points.
/// @param series columns of each interval of the file, in the order of the file's blocks
/// @param cell constants of the cell, from `cell_from_columns`
std::vector<FileFinding> check_file(const BlockFile& file,
                                    const std::vector<IntervalSeries>& series,
                                    const CellFromColumns& cell);

}  // namespace pendular
