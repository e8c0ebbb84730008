#include "workflow/json/effects.h"

#include <nlohmann/json.hpp>

#include "workflow/json/parts.h"

namespace pendular {

Part part_changed(const Effect& effect) {
    if (effect.of_instrument()) return Part::instrument;
    if (effect.of_condition()) return Part::beads_and_liquid;
    if (effect.of_grains()) return Part::grains;
    return effect.of_closure() ? Part::closure : Part::flow;
}

const char* readings_changed(const Effect& effect) {
    switch (effect.touches) {
        case Touches::dry:
            return "dry";
        case Touches::wet:
            return "wet";
        case Touches::failure:
            return "failure";
        default:
            return "all";
    }
}

Json to_json(const EffectEntry& entry) {
    constexpr const char* parts[] = {"instrument", "beads-and-liquid", "grains", "closure", "flow"};
    const Effect& effect = *entry.effect;
    Json json = {{"name", effect.name},
                 {"summary", effect.summary},
                 {"equation", effect.equation},
                 {"acts_on", parts[static_cast<std::size_t>(part_changed(effect))]},
                 {"readings", readings_changed(effect)},
                 {"parameters", Json::array()},
                 {"acts_through", effect.acts_through},
                 {"measured_by", effect.directly},
                 {"references", effect.references},
                 {"written", entry.written}};
    for (const EffectParameter& p : effect.parameters) {
        json["parameters"].push_back({{"name", p.name},
                                      {"unit", p.unit},
                                      {"lower", p.lower},
                                      {"upper", p.upper},
                                      {"neutral", p.neutral},
                                      {"smallest_of_interest", p.smallest_of_interest},
                                      {"meaning", p.meaning},
                                      {"switch", p.is_switch()}});
    }
    if (entry.status) {
        json["listed"] = entry.status->listed;
        json["applies"] = !entry.status->obstacle;
        if (entry.status->obstacle) json["why_not"] = entry.status->obstacle->sentence;
    }
    return json;
}

Json to_json(const std::vector<EffectEntry>& entries) {
    Json json = {{"effects", Json::array()}};
    for (const EffectEntry& entry : entries) {
        json["effects"].push_back(to_json(entry));
    }
    return json;
}

}  // namespace pendular
