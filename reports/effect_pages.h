#pragma once

#include <string>
#include <vector>

#include "reports/output.h"
#include "workflow/json/commands.h"

namespace pendular {

/// Returns the quantities on which the change of the readings depends, as words in a sentence:
/// "normal stress (largest at small values), height".
std::string dependences(const Effect& effect);

/// Returns a table with one line per parameter, grouped by the part of the experiment that the
/// effects change, such as the instrument.
std::vector<std::string> effects_table(const std::vector<EffectEntry>& entries);

/// Returns the description of one effect, with the settings and options that switch it on.
std::vector<std::string> effect_page(const EffectEntry& entry);

/// Returns the effect's page of the manual, in Markdown.
/// @param figure Markdown of the effect's signature figure, or the reason why there is none
std::string manual_page(const EffectEntry& entry, const std::string& figure);

/// Returns the index of the manual of effects, in Markdown, with links to the pages NAME.md.
std::string manual_index(const std::vector<EffectEntry>& entries);

/// Returns what `pendular effects` says of all effects.
/// @param all whether to say of each effect what the study lacks for it
Output effects_output(const std::vector<EffectEntry>& entries, bool all);

}  // namespace pendular
