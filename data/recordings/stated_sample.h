#pragma once

#include <optional>
#include <string>

#include "data/recordings/stated_facts.h"

namespace pendular {

/// Beads and liquid as the lines above a table state them.
struct StatedSample {
    std::optional<StatedValue> diameter;         ///< [m]
    std::optional<StatedValue> density;          ///< of the grain material [kg/m^3]
    std::optional<StatedValue> mass;             ///< of the filling [kg]
    std::optional<StatedValue> surface_tension;  ///< of the liquid [N/m]
    std::optional<StatedValue> contact_angle;    ///< of the liquid on the grains [rad]
};

/// Returns what the lines above a table state of the beads and the liquid, with names in five
/// languages.
StatedSample stated_sample(const BlockFile& file);

/// Liquid content that a file states for all of its rows.
struct StatedLiquid {
    double value = 0;      ///< [1]
    bool by_mass = false;  ///< mass of liquid over that of grains, not volume over volume
    std::string from;      ///< such as "the column 'Teneur en liquide'"
};

/// Returns the liquid content in a column of a recording; empty if it has none.
/// @throws InputError at the first row whose content differs from that of the rows before
std::optional<StatedLiquid> liquid_in_column(const BlockFile& file);

/// Returns the liquid content in a column of a recording or else above its table; empty if the file
/// states none, or one for each point of a table of points.
/// @throws InputError as `liquid_in_column`
std::optional<StatedLiquid> stated_liquid(const BlockFile& file);

}  // namespace pendular
