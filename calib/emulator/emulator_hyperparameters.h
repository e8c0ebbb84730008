#pragma once

#include <filesystem>

#include "calib/emulator/query.h"

namespace pendular {

/// Name of the file that contains the hyperparameters of the emulator (amplitudes, correlation
/// lengths and noise of the Gaussian processes), fitted to an atlas. An atlas is a set of training
/// runs, such as the simulations supplied with Pendular. The file is in the folder of the atlas.
constexpr const char* hyperparameters_name = "emulator.csv";

/// Reads the hyperparameters of the emulator (amplitudes, correlation lengths and noise of the
/// Gaussian processes) from a CSV table with a row for each observable. The first column contains
/// the name of the observable. The following columns contain the hyperparameters, in the order of
/// `Hyperparameters::names`.
/// @throws InputError, with line and column of the file, if the file cannot be read, the number of
///         columns is wrong, a value is not a number between 1e-15 and 1e15, or an observable is
///         unknown
EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file);
/// Writes the hyperparameters of the emulator (amplitudes, correlation lengths and noise of the
/// Gaussian processes) to a CSV table that `read_hyperparameters` can read.
/// @throws InputError if the file is a symbolic link to a file outside of the folder of the link
/// @throws std::runtime_error if the file cannot be written
void write_hyperparameters(const std::filesystem::path& file,
                           const EmulatorHyperparameters& hyperparameters);

}  // namespace pendular
