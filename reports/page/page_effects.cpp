#include "reports/page/page_effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>

#include "data/input_error.h"
#include "reports/diagnosis_table.h"
#include "reports/effect_pages.h"
#include "reports/failure_report.h"
#include "reports/other_causes.h"
#include "reports/page/effect_picture.h"
#include "reports/proposal_report.h"
#include "reports/verdict_report.h"
#include "reports/with_error.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

using Cells = std::vector<std::string>;

/// Chance to detect an effect [%] of the size that matters; "-" where the readings show it.
std::string chance_text(const Finding& finding) {
    return finding.p < significant_p ? "-" : fmt::format("{:.0f}", 100 * finding.power);
}

/// Smallest size of an effect that is of interest; "-" for a switch, which has none.
std::string size_text(const Candidate& candidate) {
    if (candidate.is_switch()) return "-";
    const EffectParameter& p = candidate.parameters.front();
    return with_unit(p.smallest_of_interest, p.unit);
}

/// Tables of the known effects: the first in full, the others behind a fold. Without p values where
/// none of them is small.
std::vector<PageTable> scan_tables(const PageContent& content, bool with_p) {
    const StudyModelSpace& models = *content.diagnosis.models;
    const Diagnosis& diagnosis = content.diagnosis.diagnosis;
    // All effects of a model that fails are seen, or count as absent: no chance to show.
    const bool with_chance = std::ranges::any_of(
        diagnosis.scan, [](const Finding& finding) { return finding.p >= significant_p; });
    Cells head = {"effect", "group", "value in the model", "chi2/dof with it"};
    if (with_p) head.emplace_back("p, of all tests (small: it improves the model)");
    if (with_chance)
        head.insert(head.end(), {"size that matters", "chance to detect that size [%]"});
    head.emplace_back("decision");
    PageTable first{.caption =
                        "Known effects, sorted by the change of chi2. The size that matters "
                        "is the smallest that a user wants to know of",
                    .head = head};
    PageTable others{.caption = "The other known effects", .head = head, .folded = true};
    constexpr std::size_t most = 8;  // as many as a reader compares; no rival has stood below
    for (const Finding& finding : diagnosis.scan) {
        const Candidate& candidate = models.candidates()[finding.candidate];
        Cells row = {candidate.name, candidate.group, estimate_of(diagnosis, finding, models),
                     remaining_chi2_text(diagnosis, finding, models)};
        if (with_p) row.push_back(p_text(finding.p, ""));
        if (with_chance) row.insert(row.end(), {size_text(candidate), chance_text(finding)});
        row.emplace_back(to_string(diagnosis.decision_on(finding)));
        (first.rows.size() < most ? first : others).rows.push_back(row);
    }
    return {first, others};
}

/// Explanation of the words in the tables of effects, with the decisions that occur.
std::string words_of_tables(const StudyDiagnosis& study) {
    std::vector<std::string> decisions;
    std::set<Decision> seen;
    for (const Finding& finding : study.diagnosis.scan) {
        const Decision decision = study.diagnosis.decision_on(finding);
        if (!seen.insert(decision).second) continue;
        decisions.push_back(fmt::format("\"{}\": {}", to_string(decision), meaning_of(decision)));
    }
    return fmt::format(
        "chi2/dof: mean square of residual/error, about 1 where a model fits; ~: predicted, not "
        "fitted. switch: an effect that is there or not. The chance counts that all effects are "
        "tested at once, and how well repeated readings state the errors. Decisions: {}.",
        fmt::join(decisions, "; "));
}

/// Models that explain the readings, side by side.
PageTable rivals_table(const PageContent& content) {
    PageTable table{
        .caption = "Models that explain the readings, side by side",
        .head = {"further effects", "chi2", "degrees of freedom", "friction",
                 "p (small: the model fails)", "p (small: a further effect is missing)"}};
    const Diagnosis& d = content.diagnosis.diagnosis;
    const auto add = [&](const FittedModel& each) {
        Cells names;
        for (const std::size_t k : each.chosen) {
            names.push_back(content.diagnosis.models->candidates()[k].name);
        }
        if (each.suspect) {
            names.push_back("an error of " +
                            content.diagnosis.evidence.suspects[*each.suspect].name);
        }
        table.rows.push_back({names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
                              fmt::format("{:.2f}", each.fit.chi2), fmt::format("{}", each.fit.dof),
                              estimate_text(each.fit, 0, "1"), p_text(each.lack_of_fit_p, ""),
                              p_text(each.further_p, "")});
    };
    for (const FittedModel& each : d.confidence_set) {
        add(each);
    }
    if (d.leaders) add(d.leaders->model);
    return table;
}

/// Effects that a reader wants to picture: those of the study's model, then those that the verdict
/// names, four at most.
std::vector<std::string> pictured_effects(const PageContent& content) {
    std::vector<std::string> names = names_of(content.resolved.study().model.effects);
    const StudyDiagnosis& d = content.diagnosis;
    const Verdict verdict = d.diagnosis.verdict;
    if (verdict == Verdict::missing || verdict == Verdict::indistinguishable) {
        names.insert(names.end(), d.diagnosis.effects.begin(), d.diagnosis.effects.end());
    }
    constexpr std::size_t most = 4;  // a row or two on the page
    if (names.size() > most) names.resize(most);
    return names;
}

std::vector<PagePicture> pictures_of(const PageContent& content) {
    const EffectCatalogue& catalogue = content.resolved.catalogue();
    const Study study = signature_study(built_in_effects());
    // The emulator belongs to the diagnosis, which outlives this function.
    const std::shared_ptr<const EmulatedSimulation> simulation(
        std::shared_ptr<void>(), &content.diagnosis.models->simulation());
    // Without a liquid, it cannot predict the wet readings of the pictures.
    const bool predicts = content.resolved.study().liquid.has_value();
    std::vector<PagePicture> pictures;
    for (const std::string& name : pictured_effects(content)) {
        const Effect& effect = catalogue.find(name);
        const auto& present = content.resolved.study().model.effects;
        const bool has = std::ranges::find(present, name, &ListedEffect::name) != present.end();
        PagePicture picture{.effect = name,
                            .standing = has ? "in the model" : "",
                            .summary = effect.summary,
                            .cell = cell_picture(effect),
                            .change = ""};
        try {
            if (predicts)
                picture.change = change_picture(signature_figure(effect, study, simulation));
        } catch (const std::logic_error&) {
            picture.change.clear();  // no known run has the effect, or no cell shows it
        } catch (const InputError&) {
            picture.change.clear();  // the effect does not apply to the cell of the pictures
        }
        pictures.push_back(picture);
    }
    return pictures;
}

}  // namespace

PageSection effects_section(const PageContent& content) {
    const StudyDiagnosis& d = content.diagnosis;
    PageSection section{.id = "effects", .title = "Which effect, and its rivals"};
    const auto add = [&](const std::vector<std::string>& lines) {
        section.lines.insert(section.lines.end(), lines.begin(), lines.end());
    };
    add(proposal_lines(d.proposals, d.diagnosis.base.fit.chi2, d.diagnosis.dof));
    add(close_effects_lines(d.diagnosis, *d.models));
    add(suspect_lines(d));
    if (std::string order = order_line(d, content.resolved.catalogue()); !order.empty())
        add({std::move(order)});
    const auto& scan = d.diagnosis.scan;
    const auto least = std::ranges::min_element(scan, {}, &Finding::p);
    constexpr double worth_a_column = 0.5;  // above, all p values read as 1
    const bool with_p = least != scan.end() && least->p < worth_a_column;
    if (least != scan.end() && !with_p) {
        section.lines.push_back(fmt::format(
            "No known effect improves the model: after the correction for the number of tests, the "
            "smallest p is {}.",
            p_text(least->p, "")));
    }
    section.pictures = pictures_of(content);
    section.note = words_of_tables(d);
    section.tables = {rivals_table(content)};
    std::ranges::move(scan_tables(content, with_p), std::back_inserter(section.tables));
    return section;
}

}  // namespace pendular
