#pragma once

#include <filesystem>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/lab/virtual_lab.h"

namespace pendular::bench {

/// Virtual laboratory whose grains another DEM code (LAMMPS) simulated; see
/// bench/foreign_worlds/README.md.
struct ForeignWorld {
    /// Hidden truth (true friction and effects), with the name of the virtual laboratory. The
    /// hidden effects have no parameter values.
    Truth truth;
    /// Recorded steps of constant set points, without the noise of the instrument.
    LabResult laboratory;
};

/// Reads the steady states that another DEM code (LAMMPS) simulated, and arranges the states as
/// recordings of virtual laboratories of the benchmark, one simulation for each recorded step. A
/// virtual laboratory is left out if one of its states is missing.
/// @param states bench/foreign_worlds/states.csv
/// @throws InputError if the file cannot be read, lacks a column or contains a wrong number
std::vector<ForeignWorld> read_foreign_worlds(const std::filesystem::path& states);

}  // namespace pendular::bench
