#pragma once

#include <optional>
#include <vector>

#include "data/grains.h"
#include "data/study/direct_table.h"

namespace pendular {

class StudyTable;

/// Range of values that a rig can be set to.
struct Span {
    double least = 0, greatest = 0;
};

/// Range of conditions that a rig can be set to: [rig] in study.toml.
struct Rig {
    Span normal_stress;                         ///< [Pa]
    std::optional<Span> inertial_number;        ///< [1]; one of these two
    std::optional<Span> shear_rate;             ///< [1/s]
    std::vector<double> liquid_contents = {0};  ///< Phi_L/Phi_S [1]
    /// Volumes of beads in the cell [m^3]; empty: the volume of the study's cell.
    std::vector<double> bead_volumes = {};
    int repeats = 5;          ///< most readings at one point
    int readings = 12;        ///< most in all, where one point is not enough
    double wet_cost = 1;      ///< of a wet reading, in dry ones
    double filling_cost = 0;  ///< of filling the cell with another amount of beads, in dry readings
    /// Possible waiting times between the last reading and the next one [s].
    std::vector<double> waits = {0};
    double hour_cost = 1;  ///< cost of an hour of waiting, in dry readings
    /// Effects whose parameter can be measured directly.
    std::vector<StatedDirect> direct = {};
};

/// [rig] of a study; empty where there is none.
/// @throws InputError at what is missing, unknown or impossible
std::optional<Rig> read_rig(const StudyTable& root, const GrainProperties& grains, bool has_liquid);

}  // namespace pendular
