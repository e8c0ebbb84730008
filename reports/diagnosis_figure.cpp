#include "reports/diagnosis_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/figure_style.h"
#include "reports/figure_text.h"
#include "reports/tables.h"

namespace pendular {
namespace {

constexpr std::size_t most_shown = 9;

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

}  // namespace pendular
