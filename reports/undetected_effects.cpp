#include "reports/undetected_effects.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/effect_pages.h"
#include "reports/impact_report.h"
#include "reports/joined.h"
#include "reports/with_error.h"

namespace pendular {
namespace {

/// Texts of two sizes with their unit, with as many digits as tell them apart.
std::pair<std::string, std::string> sizes_apart(double one, double other, const std::string& unit) {
    constexpr int most_digits = 5;  // sizes may be equal
    for (int digits = 2;; ++digits) {
        auto texts = std::pair(with_unit(one, unit, digits), with_unit(other, unit, digits));
        if (texts.first != texts.second || digits == most_digits) return texts;
    }
}

const Finding& finding_of(const Diagnosis& d, const ModelSpace& space, const std::string& name) {
    return *std::ranges::find_if(d.scan, [&](const Finding& finding) {
        return space.candidates()[finding.candidate].name == name;
    });
}

/// Shift of the first parameter by an effect at its smallest size of interest; "-" where the table
/// of impacts lacks the effect.
std::string shift_by(const std::optional<ImpactTable>& impacts, const std::string& effect) {
    if (!impacts) return "-";
    const auto impact = std::ranges::find(impacts->impacts, effect, &Impact::name);
    if (impact == impacts->impacts.end()) return "-";
    const double by = impact->at_interest.best()(0);
    return change_text(by, by, impacts->errors(0), "1");
}

/// Quantities that a user sets and on which the change by an effect depends.
std::string settings_of(const Effect& effect) {
    // The reduced pressure is set through the normal stress.
    std::string text = dependences(effect);
    const std::string reduced = "reduced pressure";
    if (const auto at = text.find(reduced); at != std::string::npos) {
        text.replace(at, reduced.size(), "normal stress");
    }
    return text;
}

std::string settled_by(const Effect& effect) {
    if (!effect.directly.empty()) return effect.directly;
    return effect.acts_through.empty() ? "-"
                                       : "readings over a wider range of " + settings_of(effect);
}

}  // namespace

std::vector<std::string> undetected_table(const StudyDiagnosis& study,
                                          const std::optional<ImpactTable>& impacts,
                                          const EffectCatalogue& catalogue) {
    const Diagnosis& d = study.diagnosis;
    if (d.verdict != Verdict::inconclusive || d.effects.empty()) return {};
    const auto row = [](const auto& name, const auto& shift, const auto& size, const auto& shown,
                        const auto& settled) {
        return fmt::format("  {:<24} {:>17} {:>16} {:>16}   {}", name, shift, size, shown, settled);
    };
    std::vector<std::string> lines = {row("could go undetected", "shift of friction",
                                          "size of interest", "detectable from", "settled by")};
    for (const std::string& name : impacts ? by_impact(*impacts, d.effects) : d.effects) {
        const Finding& finding = finding_of(d, *study.models, name);
        const EffectParameter& p = study.models->candidates()[finding.candidate].parameters.front();
        auto [shown, size] = sizes_apart(finding.detectable, p.smallest_of_interest, p.unit);
        if (p.is_switch()) {
            size = "switch";
            shown = fmt::format("{:.0f} % of cases", 100 * finding.power);
        } else if (p.lower < p.neutral) {
            size = "+-" + size, shown = "+-" + shown;
        }
        lines.push_back(
            row(name, shift_by(impacts, name), size, shown, settled_by(catalogue.find(name))));
    }
    lines.emplace_back(
        "  (sizes: deviation of the effect's parameter from the value without the effect. shift of "
        "friction: with an effect of the size of interest in the model. detectable from: smallest "
        "size that these readings show in 8 of 10 cases; for a switch, share of cases that show "
        "it.)");
    return lines;
}

std::string undetectable_line(const Diagnosis& d, const ModelSpace& space) {
    if (d.verdict != Verdict::inconclusive) return "";
    std::vector<std::string> names;
    for (const Finding& finding : d.scan) {
        if (!finding.identifiable) names.push_back(space.candidates()[finding.candidate].name);
    }
    if (names.empty()) return "";
    const bool several = names.size() > 1;
    return fmt::format(
        "{} {} these readings too little to be detected at any size within the bounds of {}.",
        joined(names, "and"), several ? "change" : "changes",
        several ? "their parameters" : "its parameter");
}

}  // namespace pendular
