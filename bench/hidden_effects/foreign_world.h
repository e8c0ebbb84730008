#pragma once

#include <filesystem>
#include <vector>

#include "bench/hidden_effects/truth.h"
#include "sim/lab/virtual_lab.h"

namespace pendular::bench {

/// Virtual laboratory whose grains another code simulated (bench/foreign_worlds/README.md).
struct ForeignWorld {
    Truth truth;           ///< named after the world; its effects have no values
    LabResult laboratory;  ///< recorded steps, without noise of the instrument
};

/// Reads the steady states that another code found and arranges them as recordings of the
/// benchmark's laboratory. Each recorded step has a simulation of its own. Worlds of which states
/// are missing are left out.
/// @param states bench/foreign_worlds/states.csv
/// @throws InputError where the file is not such a table
std::vector<ForeignWorld> read_foreign_worlds(const std::filesystem::path& states);

}  // namespace pendular::bench
