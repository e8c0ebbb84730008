#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// All effects available to a study: the built-in effects and the effects that the user defines in
/// study.toml. References and pointers to effects are valid as long as the catalogue exists.
class EffectCatalogue {
  public:
    /// Makes a catalogue of the built-in effects only.
    EffectCatalogue();
    /// Makes a catalogue of the built-in effects and of the effects that a study defines.
    /// @throws InputError at the line of study.toml for a user-defined effect that cannot be used
    ///         or has the name of a built-in effect
    explicit EffectCatalogue(const Study& study);
    EffectCatalogue(const EffectCatalogue&) = delete;
    EffectCatalogue& operator=(const EffectCatalogue&) = delete;
    EffectCatalogue(EffectCatalogue&&) = default;
    EffectCatalogue& operator=(EffectCatalogue&&) = default;
    ~EffectCatalogue() = default;

    /// Returns all effects available to the study. The built-in effects come first, sorted by name.
    /// The effects that the user defines follow in the order of study.toml.
    const std::vector<Effect>& all() const { return effects_; }
    /// Returns the effect, built-in or user-defined, with a given name.
    /// @throws std::invalid_argument if no effect has this name; the message suggests the nearest
    ///         name
    const Effect& find(std::string_view name) const;
    /// Whether an effect was defined by the user in study.toml rather than built in.
    bool is_written(const Effect& effect) const;

    /// Returns the effects that the list `effects` of [model] in study.toml names, in the order of
    /// the list.
    /// @throws InputError at the name of an effect that is unknown (the message suggests the
    ///         nearest name) or does not apply to the study
    std::vector<const Effect*> active(const Study& study) const;

  private:
    std::vector<Effect> effects_;
};

/// Returns the level of accuracy at which a study's model computes the strength (stress ratio) of
/// wet grains. The level is the highest among the level of the base model and the levels of the
/// listed effects. The levels are ordered from the simplest formula to the simulation.
closures::Level level_of(const Study& study);

/// Reason why an effect does not apply to a study.
struct Obstacle {
    /// Reason why the effect does not apply, in two or three words for a table, such as "needs
    /// [cell]".
    std::string brief;
    /// Reason why the effect does not apply to the study, as a sentence for the user that states a
    /// remedy.
    std::string sentence;
};

/// Returns the reason why an effect does not apply to a study; empty if the effect applies. An
/// effect does not apply if the study has no readings that the effect changes, if the study lacks
/// the liquid, cell, bead volume or base model that the effect needs, or if the study's model
/// already contains what the effect would add.
std::optional<Obstacle> obstacle(const Effect& effect, const Study& study);

/// Returns the reason why an effect does not apply to a study, as a sentence for the user that
/// states a remedy; empty if the effect applies.
std::optional<std::string> why_not(const Effect& effect, const Study& study);

}  // namespace pendular
