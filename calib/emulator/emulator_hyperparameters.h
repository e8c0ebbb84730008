#pragma once

#include <filesystem>

#include "calib/emulator/query.h"

namespace pendular {

/// Name of the file beside an atlas that keeps the scales learned from it.
constexpr const char* hyperparameters_name = "emulator.csv";

/// Reads scales from a table of a row per observable and a column per scale, and writes it.
/// @throws InputError at the cell that is wrong
EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file);
void write_hyperparameters(const std::filesystem::path& file, const EmulatorHyperparameters& hyperparameters);

}  // namespace pendular
