#include "reports/page/page_story.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "workflow/json/diagnosis.h"

namespace pendular {
namespace {

/// Models that explain the readings, or most of the misfit, the best first; empty where the verdict
/// names no effect as missing.
std::vector<const FittedModel*> proposed_models(const Diagnosis& d) {
    std::vector<const FittedModel*> models;
    if (d.verdict != Verdict::missing && d.verdict != Verdict::indistinguishable) return models;
    if (d.leaders) return {&d.leaders->model};
    for (const FittedModel& each : d.confidence_set) {
        if (!each.suspect) models.push_back(&each);
    }
    std::ranges::stable_sort(models, {}, [](const FittedModel* each) { return each->fit.chi2; });
    return models;
}

/// Combination of the study's effects and those added; empty where one of these has no switch or
/// the combination cannot be fitted.
std::optional<std::size_t> combination_with(const std::vector<std::string>& added,
                                            const SwitchedModels& switched) {
    std::size_t index = switched.current;
    for (const std::string& name : added) {
        const auto found = std::ranges::find(switched.switches, name);
        if (found == switched.switches.end()) return std::nullopt;
        index |= std::size_t(1) << std::distance(switched.switches.begin(), found);
    }
    return switched.models[index] ? std::optional(index) : std::nullopt;
}

}  // namespace

std::string step_name(const LadderStep& step) {
    if (step.effect.empty()) return step.change;
    return (step.change == "drop" ? "- " : "+ ") + step.effect;
}

PageStory page_story(const Ladder& ladder, const StudyDiagnosis& diagnosis,
                     const SwitchedModels& switched) {
    PageStory story{.ladder = ladder};
    const std::size_t rivals = diagnosis.diagnosis.confidence_set.size();
    for (const FittedModel* model : proposed_models(diagnosis.diagnosis)) {
        const std::vector<std::string> added = names_of(*model, *diagnosis.models);
        story.proposed = combination_with(added, switched);
        if (!story.proposed) continue;
        story.proposed_name =
            fmt::format("+ {} ({})", fmt::join(added, ", "),
                        rivals > 1 ? fmt::format("1 of {} rivals", rivals) : "proposed");
        break;
    }
    return story;
}

}  // namespace pendular
