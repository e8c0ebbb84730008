#pragma once

#include <filesystem>

#include "calib/emulator/query.h"

namespace pendular {

/// Name of the file beside an atlas that keeps the scales learned from it.
constexpr const char* scales_name = "emulator.csv";

/// Reads scales from a table of a row per observable and a column per scale, and writes it.
/// @throws InputError at the cell that is wrong
EmulatorScales read_scales(const std::filesystem::path& file);
void write_scales(const std::filesystem::path& file, const EmulatorScales& scales);

}  // namespace pendular
