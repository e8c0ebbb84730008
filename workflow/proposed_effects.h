#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "data/study/effect_tables.h"

namespace pendular {

/// Effects that a diagnosis proposes, as it writes them to the file proposed.toml of the results
/// folder.
struct ProposedEffects {
    /// Names of the effects of each proposal, in the order of the diagnosis.
    std::vector<std::vector<std::string>> proposals;
    std::vector<WrittenEffect> effects;  ///< definitions of all these effects
};

/// Returns an effect as a table [[effect]] of study.toml, ready to be pasted.
std::string effect_table(const WrittenEffect& effect);

/// Writes proposals to a file as tables [[effect]] that study.toml can take over; removes the file
/// where there are none.
/// @throws std::runtime_error where the file cannot be written
void write_proposed(const std::filesystem::path& file, const ProposedEffects& proposed);

/// Reads the proposals of a file that `write_proposed` wrote; empty where there is no such file.
/// @throws InputError where the file cannot be read as such
ProposedEffects read_proposed(const std::filesystem::path& file);

/// Returns the names of the effects of proposal `number`, counted from 1.
/// @throws InputError where the results folder has no such proposal, with what to do
std::vector<std::string> proposal(const std::filesystem::path& file, std::int64_t number);

}  // namespace pendular
