#pragma once

#include <filesystem>

#include "calib/emulator/query.h"

namespace pendular {

/// Name of the file beside an atlas that keeps the hyperparameters learned from it.
constexpr const char* hyperparameters_name = "emulator.csv";

/// Reads hyperparameters from a table of a row per observable and a column per hyperparameter, and
/// writes it.
/// @throws InputError at the cell that is wrong
EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file);
void write_hyperparameters(const std::filesystem::path& file,
                           const EmulatorHyperparameters& hyperparameters);

}  // namespace pendular
