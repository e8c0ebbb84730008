#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/ladder.h"

namespace pendular {

/// JSON of a ladder step, as in ladder.json.
nlohmann::ordered_json to_json(const LadderStep& ladder_step);

/// Reads the ladder from a file; empty if there is no file.
/// @throws InputError where it is cut off or something else, with what to do
Ladder read_ladder(const std::filesystem::path& file);

/// Writes the ladder, whole or not at all.
/// @throws std::runtime_error where it cannot be written
void write_ladder(const std::filesystem::path& file, const Ladder& ladder);

}  // namespace pendular
