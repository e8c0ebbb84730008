#include "reports/page/page_story.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reports/other_causes.h"
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

/// The best of the models with an error corrected; empty unless the verdict is such an error.
std::optional<CorrectedModel> corrected_model(const StudyDiagnosis& study) {
    const std::vector<SuspectError> errors = suspect_errors(study);
    if (errors.empty()) return std::nullopt;
    const SuspectError& best = *std::ranges::min_element(
        errors, {}, [](const SuspectError& error) { return error.model.fit.chi2; });
    CorrectedModel model{.of = best.suspect.name};
    const Eigen::VectorXd& predicted = best.model.fit.prediction.value;
    for (std::size_t k = 0; k < study.readings.size(); ++k) {
        for (std::size_t which = 0; which < 2; ++which) {
            const auto of = static_cast<Eigen::Index>(which);
            const double off = 100 * (1 - predicted(2 * static_cast<Eigen::Index>(k) + of) /
                                              study.readings[k].value(of));
            model.deviations[which].push_back(off);
            model.rms[which] += off * off / static_cast<double>(study.readings.size());
        }
    }
    for (double& rms : model.rms)
        rms = std::sqrt(rms);
    return model;
}

}  // namespace

std::string step_name(const LadderStep& step) {
    if (step.effect.empty()) return step.change;
    return (step.change == "drop" ? "- " : "+ ") + step.effect;
}

PageStory page_story(const Ladder& ladder, const StudyDiagnosis& diagnosis,
                     const SwitchedModels& switched) {
    PageStory story{.ladder = ladder, .corrected = corrected_model(diagnosis)};
    const std::size_t rivals = diagnosis.diagnosis.confidence_set.size();
    for (const FittedModel* model : proposed_models(diagnosis.diagnosis)) {
        const std::vector<std::string> added = names_of(*model, *diagnosis.models);
        story.proposed = combination_with(added, switched);
        if (!story.proposed) continue;
        story.proposed_name = fmt::format("+ {}", fmt::join(added, ", "));
        story.proposed_as = rivals > 1 ? fmt::format("1 of {} rivals", rivals) : "proposed";
        break;
    }
    return story;
}

}  // namespace pendular
