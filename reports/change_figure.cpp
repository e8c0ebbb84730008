#include "reports/change_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "reports/figure_style.h"

namespace pendular {
namespace {

constexpr std::array<const char*, 2> changed_quantities = {"shear stress", "solid fraction"};

/// Distinct liquid contents of readings, from the smallest.
std::vector<double> contents_in(const Comparison& comparison) {
    std::vector<double> contents;
    for (const ReadingMisfit& each : comparison.readings) {
        const double content = each.reading.condition.liquid_content;
        if (std::ranges::find(contents, content) == contents.end()) contents.push_back(content);
    }
    std::ranges::sort(contents);
    return contents;
}

std::string name_of_content(double content) {
    return content == 0 ? "dry" : fmt::format("Φ_L/Φ_S = {:.3g}", content);
}

/// Measured values less those of a model [% of the measured ones], against the normal stress.
Panel deviation_panel(const Comparison& comparison, std::size_t observable) {
    Panel panel{.x_label = "normal stress σ_{22} [Pa]", .y_label = "", .zero_line = true};
    const std::vector<double> contents = contents_in(comparison);
    const auto i = static_cast<Eigen::Index>(observable);
    std::vector<double> stresses;
    for (std::size_t n = 0; n < contents.size(); ++n) {
        Curve points =
            measured_points(name_of_content(contents[n]), look_of_series(n, contents.size()));
        points.in_key = false;
        for (const ReadingMisfit& each : comparison.readings) {
            if (each.reading.condition.liquid_content != contents[n]) continue;
            // Relative to the measured value, as the RMS errors in texts are.
            const double value = each.reading.value(i), ratio = each.predicted(i) / value;
            points.x.push_back(each.reading.condition.normal_stress);
            points.y.push_back(100 * (1 - ratio));
            points.y_error.push_back(100 * ratio * std::sqrt(each.reading.covariance(i, i)) /
                                     value);
            stresses.push_back(points.x.back());
        }
        panel.curves.push_back(points);
    }
    panel.log_x = spans_decade(stresses);
    return panel;
}

/// Gives panels the least range of y that holds the data of all.
void share_range(std::vector<Panel*> panels) {
    double least = 0, most = 0;
    for (const Panel* const panel : panels) {
        for (const Curve& curve : panel->curves) {
            for (std::size_t k = 0; k < curve.y.size(); ++k) {
                least = std::min(least, curve.y[k] - curve.y_error[k]);
                most = std::max(most, curve.y[k] + curve.y_error[k]);
            }
        }
    }
    const double margin = 0.08 * (most - least);
    for (Panel* const panel : panels)
        panel->y_range = {{least - margin, most + margin}};
}

std::string heading_of(const char* when, const Comparison& comparison) {
    return fmt::format("{}: χ^2 = {:.3g} for {} degrees of freedom", when, comparison.total.chi2,
                       comparison.total.dof);
}

}  // namespace

Figure change_figure(const ChangedStudy& changed) {
    const std::array<const Comparison*, 2> models = {&changed.before.comparison,
                                                     &changed.comparable_after().comparison};
    const bool adds = changed.change.change == Action::add;
    Figure figure{
        .name = "change",
        .title = plain_text(fmt::format("Error of the model before and after {} is {}",
                                        changed.change.effect, adds ? "added" : "dropped")),
        .panels = {},
        .columns = 2};
    for (std::size_t o = 0; o < changed_quantities.size(); ++o) {
        for (const Comparison* const model : models)
            figure.panels.push_back(deviation_panel(*model, o));
        const std::size_t before = figure.panels.size() - 2;
        share_range({&figure.panels[before], &figure.panels[before + 1]});
        figure.panels[before].y_label =
            fmt::format("{}, measured minus model [%]", changed_quantities[o]);
    }
    figure.panels[0].heading = heading_of("Before", *models[0]);
    figure.panels[1].heading = heading_of("After", *models[1]);
    std::vector<std::string> names;
    for (const double content : contents_in(*models[0]))
        names.push_back(name_of_content(content));
    for (Curve entry : series_entries(names)) {
        if (entry.style == Curve::Style::line) entry.style = Curve::Style::points;
        figure.panels[0].curves.push_back(std::move(entry));
    }
    figure.panels[0].curves.push_back(kind_entry(measured_text, Curve::Style::points));
    figure.panels[0].key = true;
    return figure;
}

}  // namespace pendular
