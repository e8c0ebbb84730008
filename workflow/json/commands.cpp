#include "workflow/json/commands.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "workflow/json/parts.h"

namespace pendular {

Json to_json(const CampaignState& state) {
    Json json = {{"runs", state.runs},
                 {"stored", state.stored},
                 {"new", state.made},
                 {"failed", state.failed},
                 {"store", state.store.string()}};
    if (const auto& seconds = state.seconds) {
        json["estimated_seconds"] = *seconds ? Json(**seconds) : Json();
    }
    return json;
}

Json page_json(const std::filesystem::path& file, const std::string& verdict,
               const std::vector<std::string>& switches, std::size_t models, const Json& runs) {
    return {{"page", file.string()},
            {"verdict", verdict},
            {"switches", switches},
            {"models", models},
            {"runs", runs}};
}

Json address_json(const std::string& address, int port) {
    return {{"address", address}, {"port", port}};
}

Json to_json(const PageState& state) {
    Json events = Json::array();
    for (const PageState::Event& each : state.events) {
        events.push_back({{"number", each.number},
                          {"time", each.time},
                          {"text", each.text},
                          {"of_effect", each.of_effect},
                          {"ok", each.ok}});
    }
    return {{"version", state.version},
            {"made", state.made},
            {"working", state.working},
            {"sentence", state.sentence},
            {"share", state.share ? Json(*state.share) : Json()},
            {"changing", state.changing},
            {"trouble", state.trouble},
            {"events", std::move(events)}};
}

Json added_json(std::size_t added, std::size_t runs) {
    return {{"added", added}, {"runs", runs}};
}

std::vector<RunDifference> differences(const dem::RunResult& first, const dem::RunResult& second) {
    const bool wet = first.parameters.wetting && second.parameters.wetting;
    std::vector<RunDifference> all;
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        const auto which = static_cast<dem::Observable>(k);
        if (!wet && dem::needs_bridges(which)) continue;
        const Mean &a = first[which], &b = second[which];
        const double difference = b.value - a.value,
                     error = std::hypot(a.standard_error, b.standard_error);
        all.push_back({which, {difference, error}, error > 0 ? difference / error : 0});
    }
    return all;
}

Json differences_json(const StoredRun& first, const StoredRun& second) {
    Json json = {{"first", first.id}, {"second", second.id}};
    for (const auto& [which, difference, standardised] : differences(first.run, second.run)) {
        json["observables"][std::string(dem::observable_names[static_cast<std::size_t>(which)])] = {
            {"difference", uncertain(difference.value, difference.standard_error)},
            {"standardised", standardised}};
    }
    return json;
}

Json manual_json(const std::filesystem::path& index,
                 const std::vector<std::pair<std::string, bool>>& pages) {
    Json json = {{"index", index.string()}, {"pages", Json::array()}};
    for (const auto& [effect, figure] : pages) {
        json["pages"].push_back({{"effect", effect}, {"figure", figure}});
    }
    return json;
}

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
