#pragma once

#include <optional>
#include <vector>

#include "data/grains.h"
#include "data/study/direct_table.h"

namespace pendular {

class StudyTable;

/// Range of values to which a measuring rig can set a quantity, in the SI unit of the quantity.
struct Span {
    double least = 0, greatest = 0;
};

/// Conditions at which a measuring rig can take further readings (measured states of the grains),
/// and costs of the readings: table [rig] of study.toml. Costs are relative to the cost of a dry
/// reading.
struct Rig {
    Span normal_stress;  ///< normal stresses that the rig can impose [Pa]
    /// Inertial numbers [1] to which the rig can be set; empty if the rig sets the shear rate.
    std::optional<Span> inertial_number;
    /// Shear rates [1/s] to which the rig can be set; empty if the rig sets the inertial number.
    std::optional<Span> shear_rate;
    /// Liquid contents (volume of liquid divided by volume of grains [1]) at which the rig can
    /// measure; 0: dry.
    std::vector<double> liquid_contents = {0};
    /// Solid volumes of the grains [m^3] with which the cell can be filled; empty: the cell is
    /// always filled with the volume in the table [cell] of the study.
    std::vector<double> bead_volumes = {};
    int repeats = 5;  ///< maximum number of further readings that the rig may take at one condition
    /// Maximum number of further readings that the rig may take at all conditions together.
    int readings = 12;
    double wet_cost = 1;  ///< cost of a wet reading, relative to the cost of a dry reading [1]
    /// Cost of filling the cell with a different amount of grains, relative to the cost of a dry
    /// reading [1].
    double filling_cost = 0;
    /// Waiting times [s] between the last reading and the next reading, among which the program
    /// chooses when it plans the next reading.
    std::vector<double> waits = {0};
    /// Cost of waiting for an hour between readings, relative to the cost of a dry reading [1].
    double hour_cost = 1;
    /// Direct measurements of effect parameters that the rig can make without shearing grains, such
    /// as the torque of the empty cell.
    std::vector<StatedDirect> direct = {};
};

/// Reads the table [rig] of study.toml: conditions at which further readings can be taken, and
/// costs of the readings. The result is empty if the table is missing.
/// @param root top level of study.toml
/// @param has_liquid whether study.toml has a table [liquid], which is required for liquid contents
///        above 0
/// @param grains grains whose density converts the key bead_mass to a solid volume
/// @throws InputError at a key that is missing, unknown or has an invalid value
std::optional<Rig> read_rig(const StudyTable& root, const GrainProperties& grains, bool has_liquid);

}  // namespace pendular
