#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "data/study/effect_tables.h"

namespace pendular {

/// Effects that a diagnosis proposes if no known effect explains the readings, as written to
/// proposed.toml. A proposal is a set of effects that would together explain the readings.
struct ProposedEffects {
    std::vector<std::vector<std::string>> proposals;  ///< names of the effects of each proposal
    std::vector<WrittenEffect> effects;  ///< effects of all proposals, defined by formulas
};

/// Returns the table [[effect]] of study.toml that defines an effect by formulas.
std::string effect_table(const WrittenEffect& effect);

/// Writes the proposals to a file: tables [[proposal]] with names of effects, and tables [[effect]]
/// that can be copied to study.toml. Removes the file if there is no proposal.
/// @throws std::runtime_error if the file cannot be written
void write_proposed(const std::filesystem::path& file, const ProposedEffects& proposed);

/// Reads the proposals from a file such as proposed.toml. Empty if the file does not exist.
/// @throws InputError if the file does not have the form that `write_proposed` writes
ProposedEffects read_proposed(const std::filesystem::path& file);

/// Returns the names of the effects of one proposal in a file such as out/proposed.toml.
/// @param number number of the proposal, from 1
/// @throws InputError if the file cannot be read or has no proposal with this number
std::vector<std::string> proposal(const std::filesystem::path& file, std::int64_t number);

}  // namespace pendular
