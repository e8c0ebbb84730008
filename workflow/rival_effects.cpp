#include "workflow/rival_effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/diagnosis/ranking.h"
#include "data/files/text_file.h"
#include "workflow/refitted_rival.h"

namespace pendular {
namespace {

using Effects = std::vector<std::string>;

std::vector<Effects> rivals_in_text(const std::string& text, const Effects& listed,
                                    const std::string& effect) {
    const auto json = nlohmann::json::parse(text);
    const std::vector<Effects> sets = json.at("confidence_set");
    const bool chosen = std::ranges::any_of(
        sets, [&](const Effects& set) { return std::ranges::find(set, effect) != set.end(); });
    if (json.at("model_effects").get<Effects>() != listed || !chosen) return {};
    std::vector<Effects> rivals;
    std::ranges::copy_if(sets, std::back_inserter(rivals), [&](const Effects& set) {
        return std::ranges::find(set, effect) == set.end();
    });
    return rivals;
}

RivalModel fitted_rival(const StudyDiagnosis& d, const std::string& removed, const Effects& added) {
    const std::string name = fmt::format("{} in place of {}", fmt::join(added, " + "), removed);
    return {.in_place_of = removed,
            .effects = added,
            .fitted = refit_rival(d, name, d.models->exchanged(removed, added))};
}

}  // namespace

Effects names_of(const std::vector<ListedEffect>& effects) {
    Effects names;
    for (const ListedEffect& effect : effects) {
        names.push_back(effect.name);
    }
    return names;
}

std::vector<Effects> rivals_in(const std::filesystem::path& file, const Study& study,
                               const std::string& effect) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return {};
    try {
        return rivals_in_text(read_text(file), names_of(study.model.effects), effect);
    } catch (const std::exception&) {
        return {};  // the file is from another version or is not of a diagnosis
    }
}

std::vector<RivalModel> rivals_not_ruled_out(const StudyDiagnosis& d, const ResolvedStudy& study,
                                             const Ladder& ladder) {
    const Effects listed = names_of(study.study().model.effects);
    const double limit = akaike(d.diagnosis.chi2, d.diagnosis.fit.parameters.size()) + ruled_out;
    std::vector<RivalModel> alive;
    std::set<std::pair<std::string, Effects>> seen;
    for (const LadderStep& step : ladder) {
        const bool in_model = std::ranges::find(listed, step.effect) != listed.end();
        for (Effects rival : step.rivals) {
            std::erase_if(rival, [&](const std::string& name) {
                return std::ranges::find(listed, name) != listed.end();
            });
            if (!in_model || rival.empty() || !seen.emplace(step.effect, rival).second) continue;
            try {
                RivalModel model = fitted_rival(d, step.effect, rival);
                if (akaike(model.fitted.chi2, model.fitted.parameters.size()) < limit) {
                    alive.push_back(std::move(model));
                }
            } catch (const std::invalid_argument&) {
                // The effect no longer exists or no earlier run has it.
            } catch (const std::domain_error&) {
                // The readings are impossible with this effect.
            }
        }
    }
    return alive;
}

std::string rivals_line(const std::vector<RivalModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue) {
    std::vector<std::string> models;
    std::set<std::string> effects;
    for (const RivalModel& rival : rivals) {
        models.push_back(fmt::format("{} (chi2 {:.2f})", rival.fitted.name, rival.fitted.chi2));
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

nlohmann::ordered_json to_json(const std::vector<RivalModel>& rivals) {
    auto json = nlohmann::ordered_json::array();
    for (const RivalModel& rival : rivals) {
        json.push_back({{"in_place_of", rival.in_place_of},
                        {"effects", rival.effects},
                        {"chi2", rival.fitted.chi2}});
    }
    return json;
}

}  // namespace pendular
