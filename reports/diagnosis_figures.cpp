#include "reports/diagnosis_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "reports/figure_style.h"
#include "reports/tables.h"

namespace pendular {
namespace {

constexpr std::size_t most_shown = 9;  ///< names along x must not touch

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

/// Adds a finite value to a curve at the x of the effect with index `place`, shifted by `aside`.
void add(Curve& curve, std::size_t place, double value, double aside = 0) {
    if (std::isfinite(value)) {
        curve.x.push_back(static_cast<double>(place) + 1 + aside);
        curve.y.push_back(value);
    }
}

Panel drop_panel(const Diagnosis& diagnosis, const std::vector<const Finding*>& findings) {
    Panel panel{.x_label = "", .y_label = "reduction of χ^2", .y_from_zero = true};
    panel.x_names.resize(findings.size());
    Curve predicted{.label = "predicted", .style = Curve::Style::bars, .colour = model_colour},
        refitted{.label = "refitted",
                 .colour = calibrated_colour,
                 .symbol = {Shape::diamond, Filling::filled}};
    for (std::size_t k = 0; k < findings.size(); ++k) {
        const double drop = std::max(0.0, findings[k]->test.predicted_reduction);
        add(predicted, k, drop);
        predicted.names.push_back(fmt::format("{:.{}f}", drop, drop < 9.95 ? 1 : 0));
        if (findings[k]->refitted_reduction) {
            add(refitted, k, std::max(0.0, *findings[k]->refitted_reduction), 0.22);
        }
    }
    panel.curves = {predicted, refitted};
    panel.references.push_back({fmt::format("χ^2 of the model, {}", freedom_text(diagnosis.dof)),
                                diagnosis.base.fit.chi2, 0, false, "#888888"});
    panel.key = Key::top_right;
    panel.headroom = 0.3;
    return panel;
}

Panel size_panel(const std::vector<const Finding*>& findings, const ModelSpace& space) {
    Panel panel{.x_label = "", .y_label = "size / smallest size of interest", .zero_line = true};
    Curve estimates{.label = "estimate, ± 1 standard error", .colour = measured_colour},
        detectable{.label = "smallest size that 80 % of such studies would show",
                   .colour = calibrated_colour,
                   .symbol = {Shape::triangle, Filling::hollow}};
    for (std::size_t k = 0; k < findings.size(); ++k) {
        const Candidate& candidate = space.candidates()[findings[k]->candidate];
        const EffectParameter& p = candidate.parameters.front();
        const double neutral = candidate.is_switch() ? 0 : p.neutral,
                     smallest_of_interest = candidate.is_switch() ? 1 : p.smallest_of_interest;
        add(estimates, k, (findings[k]->value - neutral) / smallest_of_interest);
        estimates.y_error.push_back(findings[k]->standard_error / std::abs(smallest_of_interest));
        add(detectable, k, findings[k]->detectable / std::abs(smallest_of_interest), 0.22);
        panel.x_names.push_back(broken_name(candidate.name));
    }
    panel.curves = {detectable, estimates};
    panel.references.push_back({"smallest size of interest", 1, 0, false, "#888888"});
    panel.key = Key::top_right;
    panel.headroom = 0.3;
    return panel;
}

}  // namespace

Figure diagnosis_figure(const Diagnosis& diagnosis, const ModelSpace& space) {
    Figure figure{.name = "diagnosis",
                  .title = fmt::format("Diagnosis: {}", to_string(diagnosis.verdict)),
                  .panels = {},
                  .stacked = true};
    const auto findings = most_telling(diagnosis);
    if (!findings.empty()) {
        figure.panels = {drop_panel(diagnosis, findings), size_panel(findings, space)};
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
    panel.key = Key::bottom_right;  // beside the shortest bars
    if (!panel.references.empty()) {
        panel.key = Key::top_right;  // the line at chi2 would cross a key beside the bars
        panel.headroom = 0.13;
    }
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
                  .title = "Similarity of the effects' changes of the readings (cosine)",
                  .panels = {}};
    const auto findings = telling_findings(diagnosis, most_cosines);
    if (findings.size() < 2) return figure;
    const std::size_t count = findings.size();
    Panel panel{.x_label = "", .y_label = ""};
    Curve cells{.label = "absolute cosine; 1: the readings cannot tell them apart",
                .style = Curve::Style::cells,
                .colour = model_colour};
    for (std::size_t row = 0; row < count; ++row) {
        // The first effect is in the first column and in the highest row.
        const Finding& of_row = *findings[count - 1 - row];
        panel.y_names.push_back(name_of(of_row, space));
        for (std::size_t column = 0; column < count - row; ++column) {
            const double value = cosine(of_row, *findings[column]);
            cells.x.push_back(static_cast<double>(column) + 1);
            cells.y.push_back(static_cast<double>(row) + 1);
            cells.shade.push_back(std::min(1.0, value));
            cells.names.push_back(fmt::format("{:.2f}", value));
        }
        panel.x_names.push_back(broken_name(space.candidates()[findings[row]->candidate].name));
    }
    panel.curves = {cells};
    figure.panels = {panel};
    return figure;
}

}  // namespace

std::vector<Figure> scan_figures(const Diagnosis& diagnosis, const ModelSpace& space) {
    return {scan_figure(diagnosis, space), cosine_figure(diagnosis, space)};
}

}  // namespace pendular
