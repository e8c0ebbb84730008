#pragma once

#include <filesystem>

#include "calib/emulator/query.h"

namespace pendular {

/// Name of the file, in the folder of an atlas, with the hyperparameters fitted to the atlas.
constexpr const char* hyperparameters_name = "emulator.csv";

/// Reads hyperparameters from a CSV table with a row for each observable: its name, then the
/// hyperparameters in the order of `Hyperparameters::names`.
/// @throws InputError, with line and column of the file, if the file cannot be read, has a wrong
///         number of columns, an unknown observable, or a value that is no number between 1e-15 and
///         1e15
EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file);
/// Writes hyperparameters to a CSV table that `read_hyperparameters` can read.
/// @throws InputError if the file is a symbolic link to a file outside of the folder of the link
/// @throws std::runtime_error if the file cannot be written
void write_hyperparameters(const std::filesystem::path& file,
                           const EmulatorHyperparameters& hyperparameters);

}  // namespace pendular
