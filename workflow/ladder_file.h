#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/ladder.h"

namespace pendular {

/// JSON of one step of a ladder (a study's model after one change of its effects), as in
/// ladder.json.
nlohmann::ordered_json to_json(const LadderStep& ladder_step);

/// Reads a ladder (the sequence of a study's models) from a file such as ladder.json; empty where
/// there is no file.
/// @throws InputError where the file is cut off, of another format or no ladder; the message says
///         what to do
Ladder read_ladder(const std::filesystem::path& file);

/// Writes a ladder (the sequence of a study's models) to a file such as ladder.json. Where that
/// fails, an earlier file is unchanged.
/// @throws std::runtime_error where the file cannot be written
void write_ladder(const std::filesystem::path& file, const Ladder& ladder);

}  // namespace pendular
