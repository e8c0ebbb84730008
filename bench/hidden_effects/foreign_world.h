#pragma once

#include <filesystem>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/lab/virtual_lab.h"

namespace pendular::bench {

/// Virtual laboratory whose grains another DEM code (LAMMPS) simulated; see
/// bench/foreign_worlds/README.md.
struct ForeignWorld {
    Truth truth;           ///< hidden truth, named after the world; its effects have no values
    LabResult laboratory;  ///< recorded steps, without the noise of the instrument
};

/// Reads the steady states that another DEM code (LAMMPS) simulated, and arranges the states as
/// recordings of the benchmark's virtual laboratory, one simulation for each recorded step. A world
/// is left out if one of its states is missing.
/// @param states bench/foreign_worlds/states.csv
/// @throws InputError if the file cannot be read, lacks a column or contains a wrong number
std::vector<ForeignWorld> read_foreign_worlds(const std::filesystem::path& states);

}  // namespace pendular::bench
