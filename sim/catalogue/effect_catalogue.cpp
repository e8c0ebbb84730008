#include "sim/catalogue/effect_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/catalogue/written_effect.h"

namespace pendular {
namespace {

/// Whether a source may hold wet readings. A table of readings can state liquid contents in a
/// column.
bool may_be_wet(const Source& source) {
    return source.liquid_content ? *source.liquid_content > 0
                                 : source.kind == Source::Kind::readings;
}

bool may_be_dry(const Source& source) {
    return source.liquid_content.value_or(0) == 0;
}

std::optional<Obstacle> no_such_reading(const Effect& effect, const Study& study) {
    const auto none = [&](const auto& fits) { return std::ranges::none_of(study.sources, fits); };
    if (effect.touches == Touches::wet && !study.liquid) {
        return Obstacle{"needs [liquid]",
                        effect.name +
                            " acts on wet grains, but this study has no [liquid]: add it, with wet "
                            "recordings or readings, or leave the effect out"};
    }
    if (effect.touches == Touches::wet && none(may_be_wet)) {
        return Obstacle{"needs wet readings",
                        effect.name +
                            " acts on wet grains, but this study has no reading with a "
                            "liquid_content above 0: add wet recordings or readings, or leave the "
                            "effect out"};
    }
    if (effect.touches == Touches::dry && none(may_be_dry)) {
        return Obstacle{"needs dry readings",
                        effect.name +
                            " acts on dry grains, but this study has no dry reading: add dry "
                            "recordings or readings, or leave the effect out"};
    }
    if (effect.touches == Touches::failure && none(&Source::at_failure)) {
        return Obstacle{"needs failure points",
                        effect.name +
                            " acts on points of failure, but this study has none: write state = "
                            "\"failure\" in the entry [[readings]] of the peaks, or leave the "
                            "effect out"};
    }
    return std::nullopt;
}

std::optional<Obstacle> no_table(const Effect& effect, const Study& study) {
    if (!study.cell) return std::nullopt;
    return Obstacle{"for tables",
                    effect.name +
                        " acts on tables of readings in studies without a cell, but this study has "
                        "[cell]: take an effect of the instrument, such as its gains and offsets, "
                        "in its place"};
}

std::optional<Obstacle> no_instrument(const Effect& effect, const Study& study) {
    if (!study.cell) {
        return Obstacle{"needs [cell]",
                        effect.name +
                            " acts on the instrument, but this study has no [cell]: add it with "
                            "inner_radius, outer_radius and bead_mass, or leave the effect out"};
    }
    const auto lacks_grains = [&](const Source& source) {
        return study.cell->bead_volume == 0 && !source.bead_volume;
    };
    const auto source = std::ranges::find_if(study.sources, lacks_grains);
    if (source == study.sources.end()) {
        return std::nullopt;
    }
    return Obstacle{
        "needs bead_mass",
        fmt::format("{} acts on the instrument, but it is not known how many beads were in the "
                    "cell for the entry of line {}: add bead_mass or bead_volume there or to "
                    "[cell], or leave the effect out",
                    effect.name, source->position.line)};
}

std::optional<Obstacle> no_closure(const Effect& effect, const Study& study) {
    const closures::Level level = effect.level().value();
    const std::string& base = study.model.base;
    if (closures::level_of_base(base) == closures::Level::simulation) {
        return Obstacle{
            fmt::format("not for base {}", base),
            fmt::format("{} applies only to base = \"mohr-coulomb\"{}; this study has base = "
                        "\"{}\", which makes no approximation that the effect could replace: leave "
                        "the effect out",
                        effect.name, level > closures::Level::strength3 ? " or \"rumpf\"" : "",
                        base)};
    }
    const auto part_of = [&](const std::string& brief, const std::string& sentence) {
        return Obstacle{"in " + brief, fmt::format("{} is part of {} already: leave the effect out",
                                                   effect.name, sentence)};
    };
    if (closures::level_of_base(base) >= level) {
        return part_of("base " + base, fmt::format("base = \"{}\"", base));
    }
    const auto lists = [&](const std::string& name) {
        return std::ranges::find(study.model.effects, name, &ListedEffect::name) !=
               study.model.effects.end();
    };
    const auto above = std::ranges::find_if(built_in_effects(), [&](const Effect& other) {
        return other.level() > level && lists(other.name);
    });
    if (lists(effect.name) || above == built_in_effects().end()) return std::nullopt;
    return part_of("the model", above->name);
}

/// Why an effect that is no level of the ladder of closures cannot act on the study's base model.
std::optional<Obstacle> none_beside_lines(const Effect& effect, const Study& study) {
    const bool beside = effect.touches == Touches::failure;  // the lines have no such points
    if (beside || level_of(study) != closures::Level::mohr_coulomb) return std::nullopt;
    const auto next = std::ranges::find(built_in_effects(), closures::Level::rumpf, &Effect::level);
    return Obstacle{
        fmt::format("after {}", next->name),
        fmt::format("{} cannot be told from the cohesions that base = \"mohr-coulomb\" fits to the "
                    "wet readings: add {} or a higher level of the ladder of closures first",
                    effect.name, next->name)};
}

}  // namespace

closures::Level level_of(const Study& study) {
    closures::Level level = closures::level_of_base(study.model.base);
    for (const Effect& effect : built_in_effects()) {
        const bool listed = std::ranges::find(study.model.effects, effect.name,
                                              &ListedEffect::name) != study.model.effects.end();
        if (listed && effect.of_closure()) level = std::max(level, *effect.level());
    }
    return level;
}

std::optional<Obstacle> obstacle(const Effect& effect, const Study& study) {
    if (auto found = no_such_reading(effect, study)) return found;
    if (effect.of_closure()) return no_closure(effect, study);
    if (auto found = none_beside_lines(effect, study)) return found;
    if (effect.of_table()) return no_table(effect, study);
    return effect.of_instrument() ? no_instrument(effect, study) : std::nullopt;
}

std::optional<std::string> why_not(const Effect& effect, const Study& study) {
    const auto found = obstacle(effect, study);
    return found ? std::optional(found->sentence) : std::nullopt;
}

EffectCatalogue::EffectCatalogue() : effects_(built_in_effects()) {}

EffectCatalogue::EffectCatalogue(const Study& study, const std::vector<Effect>& further)
    : EffectCatalogue() {
    for (const WrittenEffect& written : study.written_effects) {
        if (std::ranges::find(built_in_effects(), written.name, &Effect::name) !=
            built_in_effects().end()) {
            throw InputError(written.name_position,
                             fmt::format("'name': \"{0}\" is the name of a built-in effect; choose "
                                         "another name, such as \"my-{0}\"",
                                         written.name));
        }
        effects_.push_back(effect_from(written));
    }
    for (const Effect& effect : further) {
        if (std::ranges::find(effects_, effect.name, &Effect::name) != effects_.end())
            throw InputError(
                fmt::format("there is an effect \"{}\" already; choose another name", effect.name));
        effects_.push_back(effect);
    }
}

const Effect& EffectCatalogue::find(std::string_view name) const {
    return effect_named(effects_, name);
}

bool EffectCatalogue::is_written(const Effect& effect) const {
    const auto& built_in = built_in_effects();
    return std::ranges::find(built_in, effect.name, &Effect::name) == built_in.end();
}

std::vector<const Effect*> EffectCatalogue::active(const Study& study) const {
    std::vector<const Effect*> result;
    for (const ListedEffect& listed : study.model.effects) {
        try {
            result.push_back(&find(listed.name));
        } catch (const std::invalid_argument& error) {
            throw InputError(listed.position, fmt::format("'effects': {}", error.what()));
        }
        if (const auto why = why_not(*result.back(), study)) {
            throw InputError(listed.position, fmt::format("'effects': {}", *why));
        }
    }
    return result;
}

}  // namespace pendular
