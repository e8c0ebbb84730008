#include "reports/other_causes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pendular {
namespace {

/// Rank correlation from which on the contents count as measured in order [1].
constexpr double in_order = 0.9;

}  // namespace

double order_of_contents(const std::vector<Reading>& readings) {
    double with = 0, against = 0;
    for (const Reading& first : readings) {
        for (const Reading& second : readings) {
            if (first.condition.dry() || second.condition.dry()) continue;
            const double product =
                (second.condition.time - first.condition.time) *
                (second.condition.liquid_content - first.condition.liquid_content);
            (product > 0 ? with : against) += product != 0;
        }
    }
    return with + against > 0 ? (with - against) / (with + against) : 0;
}

std::string order_line(const StudyDiagnosis& diagnosis, const EffectCatalogue& catalogue) {
    const auto& named = diagnosis.diagnosis.effects;
    const auto changing = std::ranges::find_if(named, [&](const std::string& name) {
        const Effect& effect = catalogue.find(name);
        return effect.touches != Touches::dry &&
               std::ranges::find(effect.acts_through, "time") != effect.acts_through.end();
    });
    const Verdict verdict = diagnosis.diagnosis.verdict;
    if (verdict != Verdict::missing && verdict != Verdict::indistinguishable) return "";
    const double order = order_of_contents(diagnosis.readings);
    if (changing == named.end() || std::abs(order) < in_order) return "";
    return fmt::format(
        "{} changes with time, and the liquid contents were measured in {} order: an unknown "
        "change with the liquid content would look the same. Repeat the first liquid content at "
        "the end, then diagnose again.",
        *changing, order > 0 ? "increasing" : "decreasing");
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

}  // namespace pendular
