#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/block_file.h"
#include "data/recordings/findings/file_finding.h"

namespace pendular {

/// Number in the header of a file, with the position and text of the number.
struct StatedValue {
    double value = 0;  ///< the number in the header, converted to SI units
    int line = 0;      ///< line of the number in the file, from 1
    std::string key;   ///< name of the number in the header of the file, such as "Inner radius"
    std::string text;  ///< number and unit with the spelling of the file, such as "21 mm"
};

/// Radii of the annular cell, and constants that convert torque and normal force to stresses, in
/// the header of a file. A radius or constant that the header lacks is empty.
struct StatedCell {
    /// Inner and outer radius of the annular cell in the header of the file [m]. If the header
    /// gives a diameter, the radius is half of the diameter.
    std::optional<StatedValue> inner_radius, outer_radius;
    /// Ratio of shear stress to torque in the header of the file [Pa/(N m)].
    std::optional<StatedValue> stress_per_torque;
    /// Ratio of normal stress to normal force in the header of the file [1/m^2].
    std::optional<StatedValue> stress_per_force;
};

/// Returns the radii and constants of the cell in the header of a file. The keys of the header may
/// be in English, French or German. Numbers that are not positive or have no unit are left out.
StatedCell stated_cell(const BlockFile& file);

/// Adds a finding for each ratio of stress to torque or to normal force in a file's header that
/// differs by more than 5 % from the ratio in the columns of the file. If the header lacks a ratio,
/// the radii in the header give the ratio.
/// @param stated radii and ratios in the header
/// @param stress_per_torque ratio of shear stress to torque in the columns [Pa/(N m)]; 0: unknown
/// @param stress_per_force ratio of normal stress to normal force in the columns [1/m^2]; 0:
///         unknown
void check_stated_cell(const StatedCell& stated, double stress_per_torque, double stress_per_force,
                       std::vector<FileFinding>& findings);

/// Returns a finding for each radius or constant of the cell in a file's header that differs by
/// more than 1 % from the cell in study.toml.
std::vector<FileFinding> compare_with_study(const BlockFile& file, const AnnularCell& cell);

}  // namespace pendular
