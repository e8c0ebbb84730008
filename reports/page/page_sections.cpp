#include "reports/page/page_sections.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "data/remarks/wording.h"
#include "reports/diagnosis_report.h"
#include "reports/failure_report.h"
#include "reports/impact_report.h"
#include "reports/next_steps.h"
#include "reports/odd_file_report.h"
#include "reports/other_causes.h"
#include "reports/page/page_effects.h"
#include "reports/page/page_paste.h"
#include "reports/page/page_story.h"
#include "reports/verdict_report.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "workflow/json/diagnosis.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

using Cells = std::vector<std::string>;

std::string trimmed(const std::string& line) {
    const auto first = line.find_first_not_of(' ');
    return first == std::string::npos ? "" : line.substr(first);
}

/// Moves the lines after the first `most` behind a fold.
void fold_after(PageSection& section, std::size_t most, const std::string& title) {
    if (section.lines.size() <= most) return;
    const auto rest = section.lines.begin() + static_cast<std::ptrdiff_t>(most);
    section.more.assign(rest, section.lines.end());
    section.lines.erase(rest, section.lines.end());
    section.more_title = title;
}

PageSection ladder_section(const PageContent& content) {
    const PageStory story = page_story({}, content.diagnosis, content.switched);
    const bool one_model = content.ladder.empty() && !story.proposed && !story.corrected;
    PageSection section{.id = "ladder",
                        .title = one_model ? "How far the model is off" : "How the error fell",
                        .figures = "ladder-figure"};
    PageTable table{.caption = "Models of this study in the order of time",
                    .head = {"step", "change", "when", "effects", "chi2", "degrees of freedom",
                             "relative RMS error of shear stress [%]",
                             "relative RMS error of solid fraction [%]"},
                    .folded = true};
    for (const LadderStep& step : content.ladder) {
        table.rows.push_back(
            {fmt::format("{}", step.step),
             step.effect.empty() ? step.change : step.change + " " + step.effect,
             step.when.empty() ? "-" : step.when,
             step.effects.empty() ? "none" : fmt::format("{}", fmt::join(step.effects, ", ")),
             fmt::format("{:.2f}", step.chi2), fmt::format("{}", step.dof),
             fmt::format("{:.3f}", step.rms_percent[0]),
             fmt::format("{:.3f}", step.rms_percent[1])});
    }
    section.lines = {
        "Deviation of each reading from the model, 100 (1 - model/measured), with the "
        "RMS of all readings. Once you move a switch or a slider below, a further column shows its "
        "model."};
    section.tables = {table};
    return section;
}

/// Sentence on a model on one side of nearly all readings, as one that balances stress against
/// solid fraction is; empty where it is not.
std::string side_line(const StudyDiagnosis& d) {
    constexpr double nearly_all = 0.9;  // of readings around zero, chance has half on a side
    const Eigen::VectorXd& predicted = d.diagnosis.base.fit.prediction.value;
    std::vector<std::string> sides;
    for (const Eigen::Index which : {0, 1}) {
        double mean = 0, above = 0;
        const auto count = static_cast<double>(d.readings.size());
        for (std::size_t k = 0; k < d.readings.size(); ++k) {
            const double off =
                d.readings[k].value(which) / predicted(2 * static_cast<Eigen::Index>(k) + which) -
                1;
            mean += off / count;
            above += off > 0 ? 1 / count : 0;
        }
        if (above > 1 - nearly_all && above < nearly_all) continue;
        sides.push_back(fmt::format("the {} {:.2g} % {}",
                                    which == 0 ? "shear stress" : "solid fraction",
                                    100 * std::abs(mean), mean > 0 ? "higher" : "lower"));
    }
    if (sides.empty()) return "";
    return fmt::format(
        "At nearly all conditions alike, although the model is fitted: on average, {} than by the "
        "model.",
        joined(sides, "and"));
}

PageSection where_section(const PageContent& content) {
    const bool fails = !significant_checks(content.checks).empty();
    const std::string everywhere = side_line(content.diagnosis);
    PageSection section{.id = "where",
                        .title = fails ? "Where the model fails" : "Residuals of the readings",
                        .figures = "residual-figures"};
    for (const std::string& line : checks_table(content.checks)) {
        section.lines.push_back(trimmed(line));
    }
    if (section.lines.empty()) section.lines = {"No check of the residuals fails."};
    if (!everywhere.empty()) section.lines.insert(section.lines.begin(), everywhere);
    if (std::string files = files_line(content.diagnosis); !files.empty())
        section.lines.insert(section.lines.begin(), std::move(files));
    constexpr std::size_t most = 6;  // files, side, heading and the three most significant checks
    fold_after(section, most, "All checks that fail");
    return section;
}

/// Whether a line is a numbered step.
bool is_step(const std::string& line) {
    const auto digits = line.find_first_not_of("0123456789");
    return digits > 0 && digits != std::string::npos && line.compare(digits, 2, ". ") == 0;
}

PageSection next_section(const PageContent& content) {
    PageSection section{.id = "next", .title = "What to do next"};
    for (std::size_t k = 1; k < content.steps.size(); ++k) {  // the title is the heading
        const std::string line = trimmed(content.steps[k]);
        (is_step(line) ? section.lines : section.more).push_back(line);
    }
    if (section.lines.empty()) section.lines.swap(section.more);
    section.more_title = "Conditions and predictions of the planned measurements";
    section.commands = {content.command};
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
    const Cells head = {"effect or error", "group", "at the size that matters", "at the estimate",
                        "per standard error of the estimate"};
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

PageSection paste_section(const PageContent& content) {
    const PasteTexts texts = paste_texts(content);
    PageSection section{.id = "paste", .title = "To paste into a paper"};
    if (texts.csv.empty()) return section;
    section.copies = {{"paste-methods", "Methods, result and references", texts.methods},
                      {"paste-csv", "Table as CSV", texts.csv},
                      {"paste-latex", "Table for LaTeX", texts.latex}};
    return section;
}

/// Whether simulations for the study itself went into its fit.
bool is_confirmed(const FittedStudy& fitted) {
    return std::ranges::any_of(fitted.calibration.simulated,
                               [](const SimulatedRuns& each) { return each.runs > 0; });
}

std::vector<std::string> warnings_of(const PageContent& content) {
    std::vector<std::string> warnings;
    for (const std::string& reason : content.diagnosis.belief.reasons) {
        warnings.push_back("Warning: " + reason);
    }
    for (const Remark& doubt : content.measurements.doubts()) {
        std::string warning = "Warning: " + text_of(doubt);
        // A doubt is also a reason not to believe the fit.
        if (std::ranges::find(warnings, warning) == warnings.end())
            warnings.push_back(std::move(warning));
    }
    if (content.resolved.study().model.fit_to == "dry" &&
        std::ranges::none_of(content.diagnosis.readings,
                             [](const Reading& r) { return r.condition.dry(); })) {
        warnings.push_back(
            "No reading is dry, so that 'pendular calibrate' cannot fit the friction: measure the "
            "beads without liquid as well.");
    } else if (!content.calibrated || !is_confirmed(*content.calibrated)) {
        warnings.push_back(fmt::format(
            "The friction of this study is not confirmed by simulations yet: pendular calibrate {}",
            content.study_argument));
    }
    return warnings;
}

/// The value that `pendular calibrate` gave, for the study as it is.
std::string calibrated_line(const FittedStudy& fitted) {
    const std::string standing = is_confirmed(fitted) ? ": the value to report." : ".";
    return fmt::format("By 'pendular calibrate', the {} is {}{}",
                       parameter_in_words(fitted.calibration.parameters.front().name),
                       estimate_text(fitted.calibration.fit, 0, "1"),
                       fitted.belief.believable()
                           ? standing
                           : "; do not use it: " + fitted.belief.reasons.front());
}

/// Sentences on the fits of the page, for its provenance.
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

}  // namespace

PageTexts page_texts(const PageContent& content) {
    const StudyDiagnosis& d = content.diagnosis;
    const std::string answer = verdict_line(d.diagnosis, *d.models, content.checks);
    const std::string headline = verdict_headline(d.diagnosis, *d.models, content.checks);
    PageTexts texts{
        .study = content.study,
        .version = content.version,
        .headline = headline,
        .details = {},
        .measure = first_step(content.steps),
        .warnings = warnings_of(content),
        .ladder = ladder_section(content),
        .story = {where_section(content), effects_section(content), next_section(content)},
        .folded = {},
        .recordings = !content.recordings.empty()};
    const bool begins_so = answer.starts_with(headline);
    if (std::string rest = begins_so ? trimmed(answer.substr(headline.size())) : answer;
        !rest.empty())
        texts.details.push_back(std::move(rest));
    if (std::string doubt = doubt_line(d); !doubt.empty()) texts.headline += " " + doubt;
    std::ranges::move(suspect_lines(d), std::back_inserter(texts.details));
    if (std::string friction = friction_line(d, content.calibrated.has_value()); !friction.empty())
        texts.details.push_back(std::move(friction));
    // Else the page shows chi2/dof of the readings' figures and of the verdict without saying why
    // they differ.
    if (std::string granted = granted_line(d, content.resolved.study()); !granted.empty())
        texts.details.push_back(std::move(granted));
    // A suspect recording is the headline itself.
    const auto& suspects = d.evidence.suspects;
    const bool of_files = std::ranges::any_of(d.diagnosis.suspects, [&](const std::string& name) {
        const auto found = std::ranges::find(suspects, name, &SuspectMeasurement::name);
        return found != suspects.end() && found->group == "files";
    });
    if (!of_files) {
        std::string odd = odd_file_line(d);
        if (odd.empty() && !files_line(d).empty()) odd = "No file stands out from the others.";
        if (!odd.empty()) texts.details.push_back(std::move(odd));
    }
    if (content.calibrated) texts.details.push_back(calibrated_line(*content.calibrated));
    texts.folded.push_back(paste_section(content));
    if (content.impacts) texts.folded.push_back(impact_section(content));
    texts.folded.push_back(provenance_section(content));
    std::ranges::move(evidence_of(content), std::back_inserter(texts.folded.back().lines));
    return texts;
}

}  // namespace pendular
