#pragma once

#include <optional>
#include <vector>

#include "data/grains.h"
#include "data/study/direct_table.h"

namespace pendular {

class StudyTable;

/// Range of values that a measuring rig can be set to, in the unit of the quantity.
struct Span {
    double least = 0, greatest = 0;
};

/// Conditions at which a measuring rig can take further readings, and their costs: [rig] of
/// study.toml. Costs are in units of a dry reading.
struct Rig {
    Span normal_stress;                         ///< [Pa]
    std::optional<Span> inertial_number;        ///< [1]; empty if `shear_rate` is given
    std::optional<Span> shear_rate;             ///< [1/s]; empty if `inertial_number` is given
    std::vector<double> liquid_contents = {0};  ///< possible values of Phi_L/Phi_S [1]
    /// Possible solid volumes of the grains in the cell [m^3]; empty: the volume of the study's
    /// cell.
    std::vector<double> bead_volumes = {};
    int repeats = 5;          ///< largest number of readings at one condition
    int readings = 12;        ///< largest number of readings at several conditions together
    double wet_cost = 1;      ///< cost of a wet reading
    double filling_cost = 0;  ///< cost of filling the cell with another amount of grains
    /// Possible waiting times between the last reading and the next reading [s].
    std::vector<double> waits = {0};
    double hour_cost = 1;  ///< cost of an hour of waiting
    /// Measurements of an effect's parameter by itself that the rig can make.
    std::vector<StatedDirect> direct = {};
};

/// Reads the table [rig] of study.toml; empty if the study has none.
/// @param has_liquid whether the study has a table [liquid], which liquid contents above 0 need
/// @throws InputError at a key that is missing, unknown or has an invalid value
std::optional<Rig> read_rig(const StudyTable& root, const GrainProperties& grains, bool has_liquid);

}  // namespace pendular
