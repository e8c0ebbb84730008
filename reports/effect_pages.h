#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// Relation of an effect to a study.
struct EffectStatus {
    bool listed = false;               ///< whether study.toml lists the effect
    std::optional<Obstacle> obstacle;  ///< why the effect does not apply; empty: it applies
};

/// Effect as `pendular effects` prints it, with its relation to the study that the user named.
struct EffectEntry {
    const Effect* effect;
    bool written = false;                     ///< whether the user wrote it in study.toml
    std::optional<EffectStatus> status = {};  ///< empty without a study
};

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

/// Returns name, equation, parameters and bounds as JSON, with `EffectStatus` if it is known.
nlohmann::ordered_json to_json(const EffectEntry& entry);

}  // namespace pendular
