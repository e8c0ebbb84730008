#pragma once

#include <filesystem>

#include "calib/emulator/query.h"

namespace pendular {

/// Name of the file with the emulator's hyperparameters (amplitudes and lengths of its Gaussian
/// processes) that were fitted to an atlas (the training runs that come with the program). The file
/// is in the folder of the atlas.
constexpr const char* hyperparameters_name = "emulator.csv";

/// Reads the emulator's hyperparameters from a CSV table: one row for each observable, one column
/// for the observable's name and one for each hyperparameter (`Hyperparameters::names`).
/// @throws InputError, with line and column of the file, if the file cannot be read, the number of
///         columns is wrong, a value is not a positive number, or an observable is unknown
EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file);
/// Writes the emulator's hyperparameters (amplitudes and lengths of its Gaussian processes) to a
/// CSV table that `read_hyperparameters` can read.
void write_hyperparameters(const std::filesystem::path& file,
                           const EmulatorHyperparameters& hyperparameters);

}  // namespace pendular
