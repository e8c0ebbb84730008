#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/catalogue/effect.h"

namespace pendular {

/// Relation of an effect to a study.
struct EffectStatus {
    bool listed = false;                 ///< whether the study's model has the effect
    std::optional<std::string> why_not;  ///< why it does not apply to the study; empty: it applies
};

/// Entry of the catalogue of effects.
struct EffectEntry {
    const Effect* effect;
    bool written = false;                     ///< whether the user wrote the effect in study.toml
    std::optional<EffectStatus> status = {};  ///< empty without a study
};

/// Table of effects, one line per parameter, grouped by the part of the experiment that the effects
/// change.
std::vector<std::string> effects_table(const std::vector<EffectEntry>& entries);

/// Full description of one effect as lines of text, with the settings and options that switch the
/// effect on.
std::vector<std::string> effect_page(const EffectEntry& entry);

/// Page of the manual on one effect, in Markdown; `figure` is the Markdown of its figure, or the
/// reason why there is none.
std::string manual_page(const EffectEntry& entry, const std::string& figure);

/// First page of the manual, in Markdown: all effects, one row per effect, with links to NAME.md.
std::string manual_index(const std::vector<EffectEntry>& entries);

/// JSON of an entry of the catalogue of effects.
nlohmann::ordered_json to_json(const EffectEntry& entry);

}  // namespace pendular
