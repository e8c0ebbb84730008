#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/ladder.h"

namespace pendular {

/// One step of a ladder, as ladder.json holds it.
nlohmann::ordered_json to_json(const LadderStep& ladder_step);

/// The ladder in a file; empty where there is none.
/// @throws InputError where it is cut off or something else, with what to do
Ladder read_ladder(const std::filesystem::path& file);

/// Writes it whole or not at all.
/// @throws std::runtime_error where it cannot be written
void write_ladder(const std::filesystem::path& file, const Ladder& ladder);

}  // namespace pendular
