#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/ladder.h"

namespace pendular {

/// JSON of one step of a ladder, as in ladder.json: the model of a study after an effect was added
/// or dropped, with its fitted parameters, its chi2 and its errors [%].
nlohmann::ordered_json to_json(const LadderStep& ladder_step);

/// Reads a ladder, the sequence of a study's models, from a file such as ladder.json. Empty where
/// the file does not exist.
/// @throws InputError where the file is incomplete, has another format or contains no ladder
Ladder read_ladder(const std::filesystem::path& file);

/// Writes a ladder (the sequence of a study's models) to a file such as ladder.json. Where that
/// fails, an earlier file is unchanged.
/// @throws std::runtime_error where the file cannot be written
void write_ladder(const std::filesystem::path& file, const Ladder& ladder);

}  // namespace pendular
