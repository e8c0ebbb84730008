#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// All effects there are for a study: those that come with the program and those that the study
/// writes. Effects it hands out live as long as it does.
class EffectCatalogue {
  public:
    /// The built-in effects alone.
    EffectCatalogue();
    /// @throws InputError in the study's file for a written effect that cannot be used, or that is
    ///         called like a built-in one
    explicit EffectCatalogue(const Study& study);
    EffectCatalogue(const EffectCatalogue&) = delete;
    EffectCatalogue& operator=(const EffectCatalogue&) = delete;
    EffectCatalogue(EffectCatalogue&&) = default;
    EffectCatalogue& operator=(EffectCatalogue&&) = default;
    ~EffectCatalogue() = default;

    /// All effects: the built-in ones sorted by name, then the user's in the order of study.toml.
    const std::vector<Effect>& all() const { return effects_; }
    /// The effect of this name.
    /// @throws std::invalid_argument where there is none, naming the effect of the nearest name
    const Effect& find(std::string_view name) const;
    /// Whether it comes from the study.
    bool is_written(const Effect& effect) const;

    /// Effects that the study lists, in its order.
    /// @throws InputError at the name in the list where it is unknown, with the nearest one, or
    ///         does not apply to the study
    std::vector<const Effect*> active(const Study& study) const;

  private:
    std::vector<Effect> effects_;
};

/// Why an effect would do nothing in a study, or cannot be taken in, and what to do about it; empty
/// where it applies.
std::optional<std::string> why_not(const Effect& effect, const Study& study);

}  // namespace pendular
