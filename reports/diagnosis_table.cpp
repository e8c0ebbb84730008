#include "reports/diagnosis_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "reports/effect_pages.h"
#include "reports/failure_report.h"
#include "reports/impact_report.h"
#include "reports/with_error.h"
#include "reports/words.h"

namespace pendular {
namespace {

/// Refitted model with one candidate alone; null where there is none that converged.
const FittedModel* refit_with(const Diagnosis& d, std::size_t candidate) {
    const auto found = std::ranges::find_if(d.tried, [&](const FittedModel& each) {
        return each.chosen == EffectSet{candidate} && !each.suspect && each.fit.converged;
    });
    return found == d.tried.end() ? nullptr : &*found;
}

/// Meaning of each decision; line breaks are those of the command's help.
constexpr std::array<std::pair<Decision, std::string_view>, 13> meanings = {{
    {Decision::missing, "adding the effect explains the residuals"},
    {Decision::missing_with_others,
     "adding the effect explains most of the residuals, but not all"},
    {Decision::may_be_missing, "one of several effects that explain the residuals equally well"},
    {Decision::may_be_missing_too,
     "part of another set of effects that explains the residuals as well"},
    {Decision::contains_missing,
     "the effect explains the residuals, but so does a model with fewer effects"},
    {Decision::explains_most_not_all,
     "adding the effect removes at least 90 % of the excess of chi2, but leaves a\n"
     "misfit: it is not the likely cause, but worth a direct measurement"},
    {Decision::does_not_explain,
     "the residuals resemble the effect, but adding it leaves a misfit"},
    {Decision::outdone,
     "adding the effect explains the residuals, but a proposed change of unknown\n"
     "cause does so clearly better"},
    {Decision::no_sign, "something is missing, and the residuals do not resemble this effect"},
    {Decision::absent,
     "nothing is missing, and the effect would have been detected at the\n"
     "size that matters"},
    {Decision::not_excluded, "the readings might not reveal the effect at that size"},
    {Decision::not_converged, "the fit with the effect did not converge: it is not tested"},
    {Decision::not_identifiable,
     "the readings do not reveal the effect even at the bounds of its parameter"},
}};

}  // namespace

std::string decisions_in_words() {
    std::string text;
    for (const auto& [decision, meaning] : meanings) {
        text += fmt::format("  {:<26}", to_string(decision));
        for (const char c : meaning) {
            text += c;
            if (c == '\n') text += std::string(28, ' ');
        }
        text += '\n';
    }
    return text;
}

std::string meaning_of(Decision decision) {
    std::string text(
        std::ranges::find(meanings, decision, &std::pair<Decision, std::string_view>::first)
            ->second);
    std::ranges::replace(text, '\n', ' ');
    return text;
}

const Finding& finding_of(const Diagnosis& d, const ModelSpace& space, const std::string& name) {
    return *std::ranges::find_if(d.scan, [&](const Finding& finding) {
        return space.candidates()[finding.candidate].name == name;
    });
}

std::string power_text(const Finding& finding) {
    return finding.p < significant_p ? "-" : fmt::format("{:.2f}", finding.power);
}

std::string estimate_of(const Diagnosis& d, const Finding& finding, const ModelSpace& space) {
    const Candidate& candidate = space.candidates()[finding.candidate];
    if (candidate.is_switch()) return "switch";
    const std::string& unit = candidate.parameters.front().unit;
    const auto first = static_cast<Eigen::Index>(d.base.fit.parameters.size());
    const FittedModel* const refit = refit_with(d, finding.candidate);
    if (refit && refit->fit.parameters.size() > first) {
        const EffectParameter& p = candidate.parameters.front();
        const Fit& fit = refit->fit;
        const bool at_bound =
            first < std::ssize(fit.at_bound) && fit.at_bound[static_cast<std::size_t>(first)];
        return estimate_text(fit.parameters(first), fit.standard_error(first), unit,
                             p.upper - p.lower, at_bound);
    }
    return finding.standard_error > 0
               ? with_error(finding.value, finding.standard_error, unit)
               : fmt::format("{} (at its bound)", with_unit(finding.value, unit));
}

std::string remaining_chi2_text(const Diagnosis& d, const Finding& finding,
                                const ModelSpace& space) {
    const double reduction = finding.refitted_reduction.value_or(finding.test.predicted_reduction);
    const auto added = static_cast<int>(space.candidates()[finding.candidate].free_parameters());
    return fmt::format("{}{:.2f}", finding.refitted_reduction ? "" : "~",
                       std::max(0.0, d.base.fit.chi2 - reduction) / std::max(1, d.dof - added));
}

namespace {

/// Largest torque [N m] or normal force [N] of the readings, by the unit; 0 for another unit.
double largest_of(const std::string& unit, const std::vector<Reading>& readings,
                  const AnnularCell& cell) {
    double largest = 0;
    for (const Reading& reading : readings) {
        if (unit == "N m") largest = std::max(largest, torque(reading.value(0), cell));
        if (unit == "N")
            largest = std::max(largest, normal_force(reading.condition.normal_stress, cell));
    }
    return largest;
}

}  // namespace

std::vector<std::string> implausible_offsets(const Diagnosis& d, const ModelSpace& space,
                                             const std::vector<Reading>& readings,
                                             const AnnularCell& cell) {
    // Zeros of load cells and torque transducers are set to per cents of the full scale; a fifth of
    // the largest reading would be seen on the display at rest.
    constexpr double seen_at_rest = 0.2;
    std::vector<std::string> notes;
    for (const Finding& finding : d.scan) {
        const Candidate& candidate = space.candidates()[finding.candidate];
        const FittedModel* const refit = refit_with(d, finding.candidate);
        if (!refit || candidate.is_switch() ||
            std::ranges::find(d.effects, candidate.name) == d.effects.end())
            continue;
        const EffectParameter& p = candidate.parameters.front();
        const double largest = largest_of(p.unit, readings, cell),
                     value = refit->fit.parameters(d.base.fit.parameters.size());
        if (largest == 0 || std::abs(value) <= seen_at_rest * largest) continue;
        notes.push_back(fmt::format(
            "An offset of {} ({}) is implausible beside the largest reading of {}: it would be "
            "seen "
            "at rest. The usual cause is a wrong unit or radius, or an effect that is missing",
            with_unit(value, p.unit), candidate.name, with_unit(largest, p.unit)));
    }
    return notes;
}

std::vector<std::string> diagnosis_table(const Diagnosis& d, const ModelSpace& space, bool all) {
    const auto row = [&](const auto& name, const auto& value, const auto& left,
                         const auto& imitated, const auto& power, const auto& p,
                         const auto& decision) {
        const std::string tests =
            all ? fmt::format(" {:>10} {:>6} {:>8}", imitated, power, p) : std::string();
        return fmt::format("  {:<24} {:>26} {:>13}{}   {}", name, value, left, tests, decision);
    };
    std::vector<std::string> lines = {row("effect", "value in the model", "chi2/dof left",
                                          "imitated", "detect", "p", "decision")};
    std::vector<const Finding*> findings;
    for (const Finding& finding : d.scan) {
        findings.push_back(&finding);
    }
    if (d.verdict != Verdict::inconclusive) {
        std::ranges::stable_partition(findings, [&](const Finding* finding) {
            const std::string& name = space.candidates()[finding->candidate].name;
            return std::ranges::find(d.effects, name) != d.effects.end();
        });
    }
    for (const Finding* const each : findings) {
        const Finding& finding = *each;
        const Candidate& candidate = space.candidates()[finding.candidate];
        const bool seen = finding.test.seen();
        lines.push_back(row(candidate.name, seen ? estimate_of(d, finding, space) : "-",
                            seen ? remaining_chi2_text(d, finding, space) : "-",
                            fmt::format("{:.0f} %", 100 * finding.test.share_imitated),
                            seen ? power_text(finding) : "-", seen ? p_text(finding.p, "") : "-",
                            to_string(d.decision_on(finding))));
    }
    lines.push_back(fmt::format(
        "  (value in the model: the effect's parameter, fitted together with the model's "
        "parameters. chi2/dof left: with the effect in the model, now {:.2f}; ~: predicted without "
        "a fit.)",
        d.base.fit.chi2 / std::max(1, d.dof)));
    if (all) {
        lines.emplace_back(
            "  (imitated: share of the effect that a change of the fitted parameters can "
            "reproduce. detect: probability that these readings detect the effect at the size "
            "that matters. p: probability that chance alone makes the most significant of all "
            "tests at least this significant.)");
    }
    return lines;
}

namespace {

/// Texts of two sizes with their unit, with as many digits as tell them apart.
std::pair<std::string, std::string> sizes_apart(double one, double other, const std::string& unit) {
    constexpr int most_digits = 5;  // sizes may be equal
    for (int digits = 2;; ++digits) {
        auto texts = std::pair(with_unit(one, unit, digits), with_unit(other, unit, digits));
        if (texts.first != texts.second || digits == most_digits) return texts;
    }
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
                                          "size that matters", "detectable from", "settled by")};
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
        "friction: with an effect of the size that matters in the model. detectable from: smallest "
        "size that these readings show in 8 of 10 cases; for a switch, share of cases that show "
        "it.)");
    return lines;
}

std::string undetectable_line(const Diagnosis& d, const ModelSpace& space) {
    if (d.verdict != Verdict::inconclusive) return "";
    constexpr double imitated = 0.9;  // less than a third of the change is left: sqrt(1 - 0.9)
    std::vector<std::string> weak, alike;
    for (const Finding& finding : d.scan) {
        if (finding.identifiable) continue;
        auto& names = finding.test.share_imitated > imitated ? alike : weak;
        names.push_back(space.candidates()[finding.candidate].name);
    }
    std::string text;
    if (!weak.empty()) {
        text = fmt::format("{} {} these readings too little to be detected at any size.",
                           joined(weak, "and"), weak.size() > 1 ? "change" : "changes");
    }
    if (!alike.empty()) {
        text += fmt::format(
            "{}What {} would change, the fitted parameters change too: these readings cannot tell.",
            text.empty() ? "" : " ", joined(alike, "or"));
    }
    return text;
}

}  // namespace pendular
