#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "data/study/effect_tables.h"

namespace pendular {

/// Effects that a diagnosis proposes if no known effect explains the readings, as written to
/// proposed.toml in the results folder. A proposal is a set of effects that would together explain
/// the readings.
struct ProposedEffects {
    /// Names of the effects of each proposal, in the order of the diagnosis.
    std::vector<std::vector<std::string>> proposals;
    /// Effects that occur in the proposals, each defined by formulas.
    std::vector<WrittenEffect> effects;
};

/// Returns the text of a table [[effect]] that defines an effect by formulas, for study.toml.
std::string effect_table(const WrittenEffect& effect);

/// Writes the effects that a diagnosis proposes to a file: tables [[proposal]] with names of
/// effects, and tables [[effect]] that can be copied to study.toml. Removes the file if there is no
/// proposal.
/// @throws std::runtime_error if the file cannot be written
void write_proposed(const std::filesystem::path& file, const ProposedEffects& proposed);

/// Reads the effects that a diagnosis proposed from a file such as proposed.toml. Empty if the file
/// does not exist.
/// @throws InputError if the file does not have the form that `write_proposed` writes
ProposedEffects read_proposed(const std::filesystem::path& file);

/// Returns the names of the effects of one proposal (set of effects) of a diagnosis.
/// @param file file of the proposals, such as out/proposed.toml
/// @param number number of the proposal, from 1
/// @throws InputError if the file cannot be read or has no proposal with this number
std::vector<std::string> proposal(const std::filesystem::path& file, std::int64_t number);

}  // namespace pendular
