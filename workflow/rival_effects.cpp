#include "workflow/rival_effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <set>

namespace pendular {

std::vector<std::string> names_of(const std::vector<ListedEffect>& effects) {
    std::vector<std::string> names;
    for (const ListedEffect& effect : effects) {
        names.push_back(effect.name);
    }
    return names;
}

std::string rivals_line(const std::vector<FittedModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue) {
    std::vector<std::string> models;
    std::set<std::string> effects;
    for (const FittedModel& rival : rivals) {
        models.push_back(fmt::format("{} (chi2 {:.2f})", rival.name, rival.fit.chi2));
        effects.insert(rival.in_place_of);
        effects.insert(rival.effects.begin(), rival.effects.end());
    }
    if (models.empty()) return "";
    const std::string methods = direct_methods({effects.begin(), effects.end()}, catalogue);
    return fmt::format(
        "The readings do not rule out these other models: {}. The chi2 of the present model is "
        "{:.2f}.{}",
        fmt::join(models, "; "), chi2,
        methods.empty() ? "" : fmt::format(" Effects that can be measured directly: {}.", methods));
}

std::string direct_methods(const std::vector<std::string>& effects,
                           const EffectCatalogue& catalogue) {
    std::vector<std::string> methods;
    for (const std::string& name : effects) {
        const std::string& how = catalogue.find(name).directly;
        if (!how.empty()) methods.push_back(fmt::format("{} by {}", name, how));
    }
    return fmt::format("{}", fmt::join(methods, "; "));
}

nlohmann::ordered_json to_json(const std::vector<FittedModel>& rivals) {
    auto json = nlohmann::ordered_json::array();
    for (const FittedModel& rival : rivals) {
        json.push_back({{"in_place_of", rival.in_place_of},
                        {"effects", rival.effects},
                        {"chi2", rival.fit.chi2}});
    }
    return json;
}

}  // namespace pendular
