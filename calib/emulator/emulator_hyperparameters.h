#pragma once

#include <filesystem>

#include "calib/emulator/query.h"

namespace pendular {

/// Name of the file with the emulator's hyperparameters fitted to an atlas (the training runs that
/// come with the program), in the same folder as the atlas.
constexpr const char* hyperparameters_name = "emulator.csv";

/// Reads the emulator's hyperparameters from a CSV table with one row for each observable and one
/// column for each hyperparameter, after the column with the observable's name.
/// @throws InputError where the number of columns is wrong, a value is no positive number, or an
///         observable is unknown, with its place in the file
EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file);
/// Writes the emulator's hyperparameters as the CSV table that `read_hyperparameters` reads.
void write_hyperparameters(const std::filesystem::path& file,
                           const EmulatorHyperparameters& hyperparameters);

}  // namespace pendular
