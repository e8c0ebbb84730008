#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// Relation of a physical effect to a study: whether the study lists the effect, and whether the
/// effect can be added to the study.
struct EffectStatus {
    /// Whether study.toml lists the effect, so that the study's model has the effect.
    bool listed = false;
    /// Reason why the effect does not apply to the study. Empty if the effect applies.
    std::optional<Obstacle> obstacle;
};

/// Entry of the catalogue of effects, the list of all known physical effects that `pendular
/// effects` prints.
struct EffectEntry {
    const Effect* effect;
    /// Whether the user defined the effect by formulas in study.toml. If false, the effect is built
    /// into the program.
    bool written = false;
    /// Relation of the effect to the user's study: whether the study lists the effect, and whether
    /// the effect applies to the study. Empty if the user named no study.
    std::optional<EffectStatus> status = {};
};

/// Returns the names of the quantities on which the change of the shear stress and the solid
/// fraction by an effect depends, as a list for a sentence: "normal stress (largest at small
/// values), height".
std::string dependences(const Effect& effect);

/// Returns a table of physical effects as lines of text, one line per parameter of an effect. The
/// effects are grouped by the part of the experiment that they change, such as the instrument.
std::vector<std::string> effects_table(const std::vector<EffectEntry>& entries);

/// Returns the full description of one physical effect as lines of text, with the settings in
/// study.toml and the command-line options that switch the effect on.
std::vector<std::string> effect_page(const EffectEntry& entry);

/// Returns the page of the manual of effects on one physical effect, in Markdown.
/// @param figure Markdown of the figure that shows how the effect changes the readings, or the
///        reason why this figure does not exist
std::string manual_page(const EffectEntry& entry, const std::string& figure);

/// Returns the first page of the manual of effects, in Markdown. The page has tables with one row
/// per effect. Each row has a link to the page of the effect, NAME.md.
std::string manual_index(const std::vector<EffectEntry>& entries);

/// Returns the JSON of one entry of the catalogue of effects: name, equation, and parameters with
/// their bounds. If the user named a study, the JSON also states whether the study lists the effect
/// and whether the effect applies to the study.
nlohmann::ordered_json to_json(const EffectEntry& entry);

}  // namespace pendular
