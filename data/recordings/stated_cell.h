#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/block_file.h"
#include "data/recordings/stated_facts.h"

namespace pendular {

/// Radii of the annular cell and ratios of stress to torque and force that the header of a file
/// states; empty where it does not.
struct StatedCell {
    std::optional<StatedValue> inner_radius, outer_radius;  ///< [m]; half of a stated diameter
    std::optional<StatedValue> stress_per_torque;           ///< [Pa/(N m)]
    std::optional<StatedValue> stress_per_force;            ///< [1/m^2]
};

/// Returns what the header states of the cell, with names in five languages. Numbers that
/// are not positive or have no unit are left out.
StatedCell stated_cell(const BlockFile& file);

/// Returns a fault for each ratio of stress to torque or force in a header, from its radii if it
/// lacks the ratio, that differs by more than 5 % from that in the columns of the file.
/// @param stress_per_torque in the columns [Pa/(N m)]; 0: unknown
/// @param stress_per_force in the columns [1/m^2]; 0: unknown
std::vector<Remark> header_against_columns(const BlockFile& file, double stress_per_torque,
                                           double stress_per_force);

/// Returns a fault for each radius or ratio in a header that differs by more than 1 % from the cell
/// in study.toml.
std::vector<Remark> header_against_study(const BlockFile& file, const AnnularCell& cell);

}  // namespace pendular
