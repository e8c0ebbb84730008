#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/catalogue/effect.h"

namespace pendular {

/// Relation of an effect to a study.
struct EffectStatus {
    bool listed = false;                 ///< the study switches it on
    std::optional<std::string> why_not;  /// why it does not apply; empty where it does
};

/// An effect as the catalogue shows it.
struct EffectEntry {
    const Effect* effect;
    bool written = false;                     ///< by the user, in the study
    std::optional<EffectStatus> status = {};  ///< empty without a study
};

/// The catalogue, one effect a line, grouped by what they change.
std::vector<std::string> effects_table(const std::vector<EffectEntry>& entries);

/// Full description of one effect, with the way to switch it on.
std::vector<std::string> effect_page(const EffectEntry& entry);

/// A page of the manual in Markdown, of one effect; `figure` is the Markdown of its figure, or why
/// there is none.
std::string manual_page(const EffectEntry& entry, const std::string& figure);

/// The manual's first page: the catalogue, a row an effect, with links to NAME.md.
std::string manual_index(const std::vector<EffectEntry>& entries);

/// Entry of the catalogue as JSON.
nlohmann::ordered_json to_json(const EffectEntry& entry);

}  // namespace pendular
