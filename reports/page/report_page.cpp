#include "reports/page/report_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/diagnosis/study_evidence.h"
#include "data/remarks/wording.h"
#include "reports/diagnosis_report.h"
#include "reports/diagnosis_table.h"
#include "reports/failure_report.h"
#include "reports/impact_report.h"
#include "reports/next_steps.h"
#include "reports/other_causes.h"
#include "reports/page/page_data.h"
#include "reports/page/page_files.h"
#include "reports/proposal_report.h"
#include "reports/with_error.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

using kainjow::mustache::data;
using Cells = std::vector<std::string>;

/// Table of a page: a caption, a heading and rows of cells.
struct PageTable {
    std::string caption;
    Cells head;
    std::vector<Cells> rows = {};
    /// Whether the page shows the caption alone until the reader opens the table.
    bool folded = false;
};

/// Section of a page: lines of text, commands to give, and tables.
struct PageSection {
    std::string id, title;
    std::vector<std::string> lines = {}, commands = {};
    std::vector<PageTable> tables = {};
};

data list_of(const std::vector<std::string>& texts) {
    data list{data::type::list};
    for (const std::string& text : texts) {
        list << page_text(text);
    }
    return list;
}

/// Whether a column holds words: these are aligned on the left, numbers on the right.
bool holds_words(const PageTable& table, std::size_t column) {
    return std::ranges::all_of(table.rows, [&](const Cells& row) {
        return row[column].find_first_of("<+-0123456789") != 0;
    });
}

data cells_of(const Cells& cells, const std::vector<bool>& words) {
    data list{data::type::list};
    for (std::size_t column = 0; column < cells.size(); ++column) {
        data cell;
        cell.set("text", page_text(cells[column]));
        cell.set("words", words[column]);
        list << cell;
    }
    return list;
}

data to_data(const PageTable& table) {
    std::vector<bool> words;
    for (std::size_t column = 0; column < table.head.size(); ++column) {
        words.push_back(holds_words(table, column));
    }
    data rows{data::type::list};
    for (const Cells& cells : table.rows) {
        rows << data{"cells", cells_of(cells, words)};
    }
    data result;
    result.set("caption", page_text(table.caption));
    result.set("folded", table.folded);
    result.set("head", cells_of(table.head, words));
    result.set("rows", rows);
    return result;
}

data to_data(const std::vector<PageSection>& sections) {
    data result{data::type::list};
    for (const PageSection& section : sections) {
        data one, tables{data::type::list};
        for (const PageTable& table : section.tables) {
            if (!table.rows.empty()) tables << to_data(table);
        }
        one.set("id", section.id);
        one.set("title", section.title);
        one.set("lines", list_of(section.lines));
        one.set("commands", list_of(section.commands));
        one.set("tables", tables);
        result << one;
    }
    return result;
}

std::string trimmed(const std::string& line) {
    const auto first = line.find_first_not_of(' ');
    return first == std::string::npos ? "" : line.substr(first);
}

PageSection where_section(const PageContent& content) {
    PageSection section{.id = "where", .title = "Where the model fails"};
    for (const std::string& line : checks_table(content.checks)) {
        section.lines.push_back(trimmed(line));
    }
    if (section.lines.empty()) section.lines = {"No check of the residuals fails."};
    return section;
}

PageTable scan_table(const PageContent& content) {
    PageTable table{.caption = "Known effects, sorted by the change of chi2",
                    .head = {"effect", "group", "value in the model", "chi2/dof left", "p",
                             "power for an effect of the smallest size of interest", "decision"}};
    const StudyModelSpace& models = *content.diagnosis.models;
    const Diagnosis& diagnosis = content.diagnosis.diagnosis;
    for (const Finding& finding : diagnosis.scan) {
        const Candidate& candidate = models.candidates()[finding.candidate];
        table.rows.push_back(
            {candidate.name, candidate.group, estimate_of(diagnosis, finding, models),
             remaining_chi2_text(diagnosis, finding, models), p_text(finding.p, ""),
             power_text(finding), std::string(to_string(diagnosis.decision_on(finding)))});
    }
    return table;
}

/// Models that explain the readings, side by side.
PageTable rivals_table(const PageContent& content) {
    PageTable table{.caption = "Models that explain the readings, side by side",
                    .head = {"further effects", "chi2", "degrees of freedom", "friction",
                             "p: lack of fit", "p: another effect missing"}};
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

PageSection effects_section(const PageContent& content) {
    const StudyDiagnosis& d = content.diagnosis;
    PageSection section{.id = "effects", .title = "Which effect"};
    const auto add = [&](const std::vector<std::string>& lines) {
        section.lines.insert(section.lines.end(), lines.begin(), lines.end());
    };
    add(proposal_lines(d.proposals, d.diagnosis.base.fit.chi2, d.diagnosis.dof));
    add(close_effects_lines(d.diagnosis, *d.models));
    add(suspect_lines(d));
    if (std::string order = order_line(d, content.resolved.catalogue()); !order.empty())
        add({std::move(order)});
    section.tables = {rivals_table(content), scan_table(content)};
    return section;
}

/// Shift of a parameter with its sign; without a sign where it rounds to 0.
std::string shift_text(double shift) {
    const std::string text = fmt::format("{:+.4f}", shift);
    return text.find_first_of("123456789") == std::string::npos ? text.substr(1) : text;
}

PageSection impact_section(const PageContent& content) {
    const ImpactTable& impacts = *content.impacts;
    PageSection section{.id = "impacts",
                        .title = "How effects shift the fitted friction coefficient"};
    if (std::string friction = friction_line(content.diagnosis); !friction.empty()) {
        section.lines = {std::move(friction)};
    }
    const Cells head = {"effect or error", "group", "at the smallest size of interest",
                        "at the estimate", "per standard error of the estimate"};
    const std::string friction = with_error(impacts.fitted(0), impacts.errors(0));
    PageTable effects{
        .caption = fmt::format("Shift of the friction coefficient {} by each effect", friction),
        .head = head};
    PageTable errors{
        .caption = fmt::format("Shift of the friction coefficient {} by each error of measurement",
                               friction),
        .head = head,
        .folded = true};
    for (const Impact& impact : impacts.impacts) {
        const bool is_switch =
            !impact.measurement && content.diagnosis.models->candidates()[impact.index].is_switch();
        (impact.measurement ? errors : effects)
            .rows.push_back({impact_name(impact), impact.group,
                             shift_text(impact.at_interest.best()(0)),
                             shift_text(impact.at_estimate.best()(0)),
                             is_switch ? "" : fmt::format("{:.4f}", impact.by_error()(0))});
    }
    section.tables = {effects, errors};
    return section;
}

PageSection ladder_section(const PageContent& content) {
    PageSection section{.id = "ladder", .title = "Ladder of models"};
    PageTable table{.caption = "Models of this study in the order of time",
                    .head = {"step", "change", "effects", "chi2", "degrees of freedom",
                             "relative RMS error of shear stress [%]",
                             "relative RMS error of solid fraction [%]"}};
    for (const LadderStep& step : content.ladder) {
        table.rows.push_back(
            {fmt::format("{}", step.step),
             step.effect.empty() ? step.change : step.change + " " + step.effect,
             step.effects.empty() ? "none" : fmt::format("{}", fmt::join(step.effects, ", ")),
             fmt::format("{:.2f}", step.chi2), fmt::format("{}", step.dof),
             fmt::format("{:.3f}", step.rms_percent[0]),
             fmt::format("{:.3f}", step.rms_percent[1])});
    }
    section.tables = {table};
    return section;
}

PageSection next_section(const PageContent& content) {
    PageSection section{.id = "next", .title = "What to do next"};
    for (std::size_t k = 1; k < content.steps.size(); ++k) {  // the title is the heading
        section.lines.push_back(trimmed(content.steps[k]));
    }
    section.commands = {content.command};
    return section;
}

/// Names of all effects that the page shows: listed, switched or named by the verdict.
std::vector<std::string> used_effects(const PageContent& content) {
    std::set<std::string> names(content.switched.switches.begin(), content.switched.switches.end());
    names.insert(content.switched.always.begin(), content.switched.always.end());
    const Diagnosis& d = content.diagnosis.diagnosis;
    if (d.verdict != Verdict::inconclusive) names.insert(d.effects.begin(), d.effects.end());
    return {names.begin(), names.end()};
}

/// Number of the readings behind a page, and of the means that it shows in their place.
std::string readings_text(const StudyDiagnosis& d) {
    if (d.readings.size() == d.measured) return fmt::format("{} readings", d.measured);
    return fmt::format("the means of {} bins of neighbouring conditions, of {} readings,",
                       d.readings.size(), d.measured);
}

PageSection provenance_section(const PageContent& content) {
    PageSection section{.id = "provenance", .title = "Provenance"};
    section.lines = {
        fmt::format("Made by Pendular {} from {} and {} earlier simulations (hash {}), "
                    "fidelity {}, seed {}.",
                    content.version, readings_text(content.diagnosis), content.runs,
                    content.runs_hash, content.options.fidelity.name, content.options.seed),
        "No simulation was made for the fits of this page: the emulator predicts what simulations "
        "would give, with its error. 'pendular calibrate' confirms the fit of the study's model by "
        "new simulations.",
        "Contact and capillary laws, closures and the friction's calibration follow Badetti, Fall, "
        "Chevoir and Roux, Shear strength of wet granular materials: macroscopic cohesion and "
        "effective stress (2018)."};
    section.commands = {"pendular report " + content.study_argument};
    PageTable table{.caption = "Sources of the effects on this page",
                    .head = {"effect", "sources"}};
    for (const std::string& name : used_effects(content)) {
        const Effect& effect = content.resolved.catalogue().find(name);
        table.rows.push_back({name, effect.references.empty()
                                        ? effect.summary
                                        : fmt::format("{}", fmt::join(effect.references, "; "))});
    }
    section.tables = {table};
    return section;
}

std::vector<PageSection> sections_of(const PageContent& content) {
    std::vector<PageSection> sections = {where_section(content), effects_section(content)};
    if (content.impacts) sections.push_back(impact_section(content));
    if (!content.ladder.empty()) sections.push_back(ladder_section(content));
    sections.push_back(next_section(content));
    sections.push_back(provenance_section(content));
    return sections;
}

/// Sentences on the fits of the page.
std::vector<std::string> evidence_of(const PageContent& content) {
    std::vector<std::string> lines = {fit_line(content.diagnosis.diagnosis)};
    const auto& current = content.switched.models[content.switched.current];
    if (current && current->calibration.model.fit_to == "all" &&
        content.resolved.study().model.fit_to == "dry") {
        lines.push_back(
            "All models on this page are fitted to all readings, so that their errors can be "
            "compared. 'pendular calibrate' fits the dry readings alone where no effect of the "
            "study needs the wet ones.");
    }
    return lines;
}

std::vector<std::string> warnings_of(const PageContent& content) {
    std::vector<std::string> warnings;
    for (const std::string& reason : content.diagnosis.belief.reasons) {
        warnings.push_back("Warning: " + reason);
    }
    for (const Remark& doubt : content.measurements.doubts()) {
        warnings.push_back("Warning: " + text_of(doubt));
    }
    if (content.resolved.study().model.fit_to == "dry" &&
        std::ranges::none_of(content.diagnosis.readings,
                             [](const Reading& r) { return r.condition.dry(); })) {
        warnings.push_back(
            "No reading is dry, so that 'pendular calibrate' cannot fit the friction: measure the "
            "beads without liquid as well.");
    } else if (!content.calibrated) {
        warnings.push_back(fmt::format(
            "This study has not been calibrated yet: give 'pendular calibrate {}' to confirm its "
            "fit by simulations.",
            content.study_argument));
    }
    return warnings;
}

/// JSON that can stand in a script element: no text in it can end the element.
std::string for_script(const nlohmann::ordered_json& json) {
    std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string safe;
    for (const char c : text) {
        if (c == '<') {
            safe += "\\u003c";
        } else {
            safe += c;
        }
    }
    return safe;
}

}  // namespace

std::string page_policy(bool served) {
    return fmt::format(
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; "
        "connect-src {}; base-uri 'none'; form-action 'none'",
        served ? "'self'" : "'none'");
}

namespace {

/// Parts of the template that do not depend on results. `served_version`: version of the page of a
/// server; empty: a page without a server.
data frame_of_page(const std::string& study, const std::string& version,
                   const std::optional<std::size_t>& served_version) {
    data values;
    values.set("study", study);
    values.set("policy", page_policy(served_version.has_value()));
    values.set("style", std::string(page_style));
    std::string script = page_script;
    if (served_version) script += page_serve_script;
    values.set("script", script);
    values.set("made_by", "Pendular " + version);
    if (served_version) values.set("served", data{"version", std::to_string(*served_version)});
    return values;
}

}  // namespace

std::string waiting_page(const std::string& study, const std::string& version) {
    kainjow::mustache::mustache page{page_template};
    data values = frame_of_page(study, version, 0);
    values.set("verdict", "There are no results on this study yet.");
    return page.render(values);
}

std::string report_page(const PageContent& content) {
    const StudyDiagnosis& d = content.diagnosis;
    kainjow::mustache::mustache page{page_template};
    data values = frame_of_page(content.study, content.version, content.served_version);
    values.set("results", data::type::bool_true);
    values.set("measure", page_text(first_step(content.steps)));
    values.set("verdict", page_text(verdict_line(d.diagnosis, *d.models, content.checks)));
    values.set("warnings", list_of(warnings_of(content)));
    values.set("evidence", list_of(evidence_of(content)));
    values.set("sections", to_data(sections_of(content)));
    values.set("recordings", !content.recordings.empty());
    values.set("data", for_script(page_data(content.switched, content.panels, content.recordings)));
    return page.render(values);
}

}  // namespace pendular
