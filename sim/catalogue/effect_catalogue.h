#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// All effects available to a study: the built-in effects and those that the user defines in
/// study.toml. References and pointers to effects are valid as long as the catalogue exists.
class EffectCatalogue {
  public:
    /// Makes a catalogue of the built-in effects only.
    EffectCatalogue();
    /// Makes a catalogue of the built-in effects and of those that a study defines.
    /// @throws InputError at the line of study.toml for a user-defined effect that cannot be used
    ///         or has the name of a built-in effect, and for one of `further` whose name is taken
    /// @param further effects that a program has in place of formulas
    explicit EffectCatalogue(const Study& study, const std::vector<Effect>& further = {});
    EffectCatalogue(const EffectCatalogue&) = delete;
    EffectCatalogue& operator=(const EffectCatalogue&) = delete;
    EffectCatalogue(EffectCatalogue&&) = default;
    EffectCatalogue& operator=(EffectCatalogue&&) = default;
    ~EffectCatalogue() = default;

    /// Returns the built-in effects, sorted by name, then those of the user in the order of
    /// study.toml.
    const std::vector<Effect>& all() const { return effects_; }
    /// Returns the effect of a given name.
    /// @throws std::invalid_argument if there is none of this name; the message suggests the
    ///         nearest name
    const Effect& find(std::string_view name) const;
    /// Whether an effect was defined by the user.
    bool is_written(const Effect& effect) const;

    /// Returns the effects of the list `effects` of [model] in study.toml, in its order.
    /// @throws InputError at the name of an effect that is unknown or does not apply to the study
    std::vector<const Effect*> active(const Study& study) const;

  private:
    std::vector<Effect> effects_;
};

/// Returns the level at which a study's model computes the strength of wet grains: the highest of
/// the base model's and of the listed effects'.
closures::Level level_of(const Study& study);

/// Reason why an effect does not apply to a study.
struct Obstacle {
    std::string brief;     ///< two or three words for a table, such as "needs [cell]"
    std::string sentence;  ///< for the user, with a remedy
};

/// Returns the reason why an effect does not apply to a study; empty if the effect applies. A study
/// may have no readings that the effect changes, lack the liquid, cell, bead volume or base model
/// that the effect needs, or have a model that already contains what the effect would add.
std::optional<Obstacle> obstacle(const Effect& effect, const Study& study);

/// Returns the sentence of `obstacle`; empty if the effect applies.
std::optional<std::string> why_not(const Effect& effect, const Study& study);

}  // namespace pendular
