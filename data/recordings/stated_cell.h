#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/block_file.h"
#include "data/recordings/findings/file_finding.h"

namespace pendular {

/// Number that the header of a file states.
struct StatedValue {
    double value = 0;  ///< in SI units
    int line = 0;      ///< line of the file
    std::string key;   ///< name of the number in the file: "Inner radius"
    std::string text;  ///< number and unit as the file writes them: "21 mm"
};

/// Radii and constants of the cell that the header of a file states.
struct StatedCell {
    std::optional<StatedValue> inner_radius, outer_radius;  ///< [m]; half of a stated diameter
    std::optional<StatedValue> stress_per_torque;           ///< [Pa/(N m)]
    std::optional<StatedValue> stress_per_force;            ///< [1/m^2]
};

/// Radii and constants of the cell that the header of a file states, in English, French or German.
/// Numbers without a unit, or of 0, are left out.
StatedCell stated_cell(const BlockFile& file);

/// Adds findings on numbers of the header that differ from the constants that the columns of the
/// file show by more than 5 %, the accuracy of these constants.
/// @param stress_per_torque shear stress over torque in the columns [Pa/(N m)]; 0: unknown
/// @param stress_per_force normal stress over normal force in the columns [1/m^2]; 0: unknown
void check_stated_cell(const StatedCell& stated, double stress_per_torque, double stress_per_force,
                       std::vector<FileFinding>& findings);

/// Findings on numbers of the header that differ by more than 1 % from those of the cell that
/// study.toml states.
std::vector<FileFinding> compare_with_study(const BlockFile& file, const AnnularCell& cell);

}  // namespace pendular
