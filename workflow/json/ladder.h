#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/ladder.h"

namespace pendular {

/// Returns the JSON of one ladder step. Relative RMS errors are in %.
nlohmann::ordered_json to_json(const LadderStep& ladder_step);

/// Reads a ladder from a file such as ladder.json. Empty if the file does not exist.
/// @throws InputError if the file exists but is incomplete, is not in the format of a ladder, or
///         contains no ladder
Ladder read_ladder(const std::filesystem::path& file);

/// Writes a ladder to a file such as ladder.json. If writing fails, an earlier file is unchanged.
/// @throws std::runtime_error if the file cannot be written
void write_ladder(const std::filesystem::path& file, const Ladder& ladder);

}  // namespace pendular
