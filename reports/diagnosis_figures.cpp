#include "reports/diagnosis_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "reports/figure_style.h"
#include "reports/impact_report.h"
#include "reports/proposal_report.h"
#include "reports/tables.h"

namespace pendular {
namespace {

constexpr std::size_t most_shown = 9;  ///< chosen: two panels of as many rows are half a page

/// Findings on effects that the readings could reveal, at most nine, the largest reduction of chi2
/// first.
std::vector<const Finding*> most_telling(const Diagnosis& diagnosis) {
    std::vector<const Finding*> findings;
    for (const Finding& finding : diagnosis.scan) {
        if (finding.test.seen() && finding.identifiable && findings.size() < most_shown) {
            findings.push_back(&finding);
        }
    }
    return findings;
}

/// Row of the effect with index `place` of `count`: rows count upwards, the first effect is at the
/// top.
double row_of(std::size_t place, std::size_t count) {
    return static_cast<double>(count - place);
}

Panel drop_panel(const Diagnosis& diagnosis, const std::vector<const Finding*>& findings,
                 const std::vector<std::string>& names) {
    Panel panel{.x_label = "reduction of χ^2", .y_label = ""};
    panel.y_names = names;
    Curve predicted{.label = "predicted from the residuals",
                    .style = Curve::Style::bars_across,
                    .colour = model_colour},
        refitted{.label = "found by a refit",
                 .colour = calibrated_colour,
                 .symbol = {Shape::diamond, Filling::filled}};
    double reach = diagnosis.base.fit.chi2;
    for (std::size_t k = 0; k < findings.size(); ++k) {
        predicted.x.push_back(std::max(0.0, findings[k]->test.predicted_reduction));
        predicted.y.push_back(row_of(k, findings.size()));
        reach = std::max(reach, predicted.x.back());
        if (findings[k]->refitted_reduction) {
            refitted.x.push_back(std::max(0.0, *findings[k]->refitted_reduction));
            refitted.y.push_back(predicted.y.back());
            reach = std::max(reach, refitted.x.back());
        }
    }
    panel.curves = {predicted};
    if (!refitted.x.empty()) panel.curves.push_back(refitted);
    panel.references.push_back({fmt::format("χ^2 of the model, {}", freedom_text(diagnosis.dof)),
                                diagnosis.base.fit.chi2, 0, true, "#888888"});
    panel.x_range = {0, 1.08 * reach};
    panel.key = true;
    return panel;
}

/// Least size on the axis of sizes [size that matters]: smaller ones are drawn there.
constexpr double least_size = 0.01;

Panel size_panel(const std::vector<const Finding*>& findings, const ModelSpace& space,
                 const std::vector<std::string>& names) {
    Panel panel{.x_label = "size of the effect/size that matters", .y_label = "", .log_x = true};
    panel.y_names = names;
    panel.x_uncertain = true;
    Curve increase{.label = "estimate, ± 1 standard error", .colour = measured_colour},
        decrease{.label = "the same, of negative sign",
                 .colour = measured_colour,
                 .symbol = {Shape::downward_triangle, Filling::filled}},
        detectable{.label = "size that 80 % of such studies would detect",
                   .colour = calibrated_colour,
                   .symbol = {Shape::triangle, Filling::hollow}};
    double least = 1, most = 1;
    for (std::size_t k = 0; k < findings.size(); ++k) {
        const Candidate& candidate = space.candidates()[findings[k]->candidate];
        const EffectParameter& p = candidate.parameters.front();
        const double neutral = candidate.is_switch() ? 0 : p.neutral,
                     matters = std::abs(candidate.is_switch() ? 1 : p.smallest_of_interest);
        const double size = (findings[k]->value - neutral) / matters,
                     error = findings[k]->standard_error / matters,
                     found = findings[k]->detectable / matters;
        if (std::isfinite(size)) {
            Curve& estimates = size < 0 ? decrease : increase;
            estimates.x.push_back(std::max(std::abs(size), least_size));
            estimates.y.push_back(row_of(k, findings.size()));
            estimates.x_error.push_back(std::isfinite(error) ? error : 0);
            least = std::min(least, estimates.x.back());
            most = std::max(most, estimates.x.back() + estimates.x_error.back());
        }
        if (std::isfinite(found) && found > 0) {
            detectable.x.push_back(std::max(found, least_size));
            detectable.y.push_back(row_of(k, findings.size()));
            least = std::min(least, detectable.x.back());
            most = std::max(most, detectable.x.back());
        }
    }
    for (const Curve* const curve : {&detectable, &increase, &decrease})
        if (!curve->x.empty()) panel.curves.push_back(*curve);
    panel.references.push_back({"size that matters", 1, 0, true, "#888888"});
    panel.x_range = {least / 1.6, most * 1.6};
    panel.key = true;
    return panel;
}

/// Title of the figure for a verdict.
std::string title_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::nothing_missing:
            return "Nothing is missing from the model: the effects tested";
        case Verdict::inconclusive:
            return "The model describes the readings: effects that it may still lack";
        case Verdict::missing:
            return "An effect is missing from the model: the effects tested";
        case Verdict::indistinguishable:
            return "Several effects explain the readings equally well";
        case Verdict::unknown:
            return "Something is missing that no known effect explains";
        case Verdict::suspect_measurement:
            return "Part of the measurement may be wrong: the effects tested";
    }
    return "";
}

}  // namespace

Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space) {
    Figure figure{
        .name = "diagnosis", .title = title_of(diagnosis.verdict), .panels = {}, .stacked = true};
    const auto findings = most_telling(diagnosis);
    std::vector<std::string> names;
    for (auto finding = findings.rbegin(); finding != findings.rend(); ++finding)
        names.push_back(plain_text(space.candidates()[(*finding)->candidate].name));
    if (!findings.empty()) {
        figure.panels = {drop_panel(diagnosis, findings, names),
                         size_panel(findings, space, names)};
    }
    return figure;
}

namespace {

/// Chosen: what one page shows legibly, as rows and as cells with a number in each.
constexpr std::size_t most_effects = 20, most_cosines = 10;

/// Findings on effects that the readings tell something about, at most `most`, the largest
/// reduction of chi2 first.
std::vector<const Finding*> telling_findings(const Diagnosis& diagnosis, std::size_t most) {
    std::vector<const Finding*> findings;
    for (const Finding& finding : diagnosis.scan) {
        if (finding.test.seen()) findings.push_back(&finding);
    }
    std::ranges::stable_sort(findings, std::greater(), [](const Finding* finding) {
        return finding->test.predicted_reduction;
    });
    findings.resize(std::min(findings.size(), most));
    return findings;
}

std::string name_of(const Finding& finding, const ModelSpace& space) {
    return plain_text(space.candidates()[finding.candidate].name);
}

Figure scan_figure(const Diagnosis& diagnosis, const ModelSpace& space) {
    Figure figure{.name = "scan",
                  .title = "Reduction of χ^2 by each effect, predicted and refitted",
                  .panels = {}};
    const auto findings = telling_findings(diagnosis, most_effects);
    if (findings.empty()) return figure;
    Panel panel{.x_label = "reduction of χ^2", .y_label = ""};
    Curve predicted{.label = "predicted from the residuals",
                    .style = Curve::Style::bars_across,
                    .colour = model_colour},
        refitted{.label = "found by a refit",
                 .colour = calibrated_colour,
                 .symbol = {Shape::diamond, Filling::filled}};
    double reach = 0;
    for (auto finding = findings.rbegin(); finding != findings.rend(); ++finding) {
        panel.y_names.push_back(name_of(**finding, space));
        const double row = static_cast<double>(panel.y_names.size());
        predicted.x.push_back(std::max(0.0, (*finding)->test.predicted_reduction));
        predicted.y.push_back(row);
        reach = std::max(reach, predicted.x.back());
        if ((*finding)->refitted_reduction) {
            refitted.x.push_back(std::max(0.0, *(*finding)->refitted_reduction));
            refitted.y.push_back(row);
            reach = std::max(reach, refitted.x.back());
        }
    }
    panel.curves = {predicted};
    if (!refitted.x.empty()) panel.curves.push_back(refitted);
    // Where no effect takes a good part of chi2, a line at chi2 would squeeze the bars.
    if (diagnosis.base.fit.chi2 < 3 * reach) {
        panel.references = {{fmt::format("χ^2 of the model, {}", freedom_text(diagnosis.dof)),
                             diagnosis.base.fit.chi2, 0, true, "#888888"}};
        reach = std::max(reach, diagnosis.base.fit.chi2);
    }
    constexpr double least_reach = 4;  // reduction that chance gives in one of 20 tests
    panel.x_range = {0, 1.08 * std::max(reach, least_reach)};
    panel.key = true;
    figure.panels = {panel};
    return figure;
}

/// Similarity of the changes of the readings by two effects: the absolute cosine of the whitened
/// changes, minus what the calibrated parameters imitate [1].
double cosine(const Finding& a, const Finding& b) {
    return std::abs(a.test.basis.col(0).dot(b.test.basis.col(0)));
}

Figure cosine_figure(const Diagnosis& diagnosis, const ModelSpace& space) {
    Figure figure{.name = "cosines",
                  .title = "Similarity of the changes that two effects make to the readings",
                  .panels = {}};
    const auto findings = telling_findings(diagnosis, most_cosines);
    if (findings.size() < 2) return figure;
    const std::size_t count = findings.size();
    Panel panel{.x_label = "", .y_label = ""};
    Curve cells{.label = "similarity [%]: at 100 %, the readings cannot tell two effects apart",
                .style = Curve::Style::cells,
                .colour = model_colour};
    for (std::size_t row = 0; row < count; ++row) {
        // The first effect is in the first column and in the highest row.
        const Finding& of_row = *findings[count - 1 - row];
        panel.y_names.push_back(fmt::format("{}  {}", name_of(of_row, space), count - row));
        for (std::size_t column = 0; column < count - row; ++column) {
            const double value = cosine(of_row, *findings[column]);
            cells.x.push_back(static_cast<double>(column) + 1);
            cells.y.push_back(static_cast<double>(row) + 1);
            cells.shade.push_back(std::min(1.0, value));
            cells.names.push_back(fmt::format("{:.0f}", 100 * value));
        }
        panel.x_names.push_back({fmt::format("{}", row + 1)});
    }
    panel.curves = {cells};
    panel.key = true;
    figure.panels = {panel};
    return figure;
}

}  // namespace

std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space) {
    return {scan_figure(diagnosis, space), cosine_figure(diagnosis, space)};
}

std::vector<Figure> diagnosis_figures(const StudyDiagnosis& d,
                                      const std::optional<ImpactTable>& impacts) {
    const Diagnosis& diagnosis = d.diagnosis;
    std::vector<Figure> figures = {diagnosis_figure(diagnosis, *d.models)};
    std::ranges::move(scan_figures(diagnosis, *d.models), std::back_inserter(figures));
    if (!d.proposals.empty()) {
        figures.push_back(
            proposal_figure(d.proposals.front(), d.readings, diagnosis.base.fit.prediction));
    }
    if (impacts) figures.push_back(impact_figure(*impacts));
    return figures;
}

}  // namespace pendular
