#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
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

/// Parts of the experiment that an effect changes.
enum class Part : std::size_t { instrument, beads_and_liquid, grains, closure, flow };

/// Returns the part of the experiment that an effect changes.
Part part_changed(const Effect& effect);

/// Returns the readings that an effect changes: "dry", "wet", "failure" or "all".
const char* readings_changed(const Effect& effect);

/// Returns name, equation, parameters and bounds as JSON, with `EffectStatus` if it is known.
nlohmann::ordered_json to_json(const EffectEntry& entry);

nlohmann::ordered_json to_json(const std::vector<EffectEntry>& entries);

}  // namespace pendular
