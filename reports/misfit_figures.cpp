#include "reports/misfit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

#include "data/quantities/distributions.h"
#include "data/quantities/number.h"
#include "reports/figure_style.h"
#include "reports/figure_text.h"

namespace pendular {
namespace {

/// Expected quantile of the value of rank k (from 0) of n ordered normal values [1].
/// Source: Blom, Statistical Estimates and Transformed Beta-Variables (1958), with 3/8.
double expected_quantile(std::size_t k, std::size_t n) {
    return normal_quantile((static_cast<double>(k) + 0.625) / (static_cast<double>(n) + 0.25));
}

/// Decorrelated residuals of one observable, in standard errors [1], in rising order.
std::vector<double> residuals_of(const Comparison& comparison, Eigen::Index observable) {
    std::vector<double> residuals;
    for (const ReadingMisfit& misfit : comparison.readings) {
        residuals.push_back(
            std::copysign(std::sqrt(misfit.chi2(observable)), misfit.normalised(observable)));
    }
    std::ranges::sort(residuals);
    return residuals;
}

/// Band in which an ordered residual of a correct model lies with a probability of 95 %:
///     q +- 1.96 sqrt(P (1 - P)/n)/phi(q),  P: probability below the quantile q, phi: density.
/// Source: Chambers et al., Graphical Methods for Data Analysis (1983), section 6.7.
Curve expected_band(std::size_t n) {
    Curve band{
        .label = "normal errors, 95 %", .style = Curve::Style::band, .colour = explaining_colour};
    for (std::size_t k = 0; k < n; ++k) {
        const double q = expected_quantile(k, n), below = normal_below(q);
        band.x.push_back(q);
        band.y.push_back(q);
        band.y_error.push_back(1.96 * std::sqrt(below * (1 - below) / static_cast<double>(n)) /
                               normal_density(q));
    }
    return band;
}

Figure quantile_figure(const Comparison& comparison) {
    Figure figure{.name = "qq", .title = "Residuals against a normal distribution", .panels = {}};
    const std::size_t n = comparison.readings.size();
    if (n < 3) return figure;
    Panel panel{.x_label = "quantile of the normal distribution [standard errors]",
                .y_label = "ordered residual [standard errors]"};
    Curve line = expected_band(n);
    panel.curves.push_back(line);
    line.style = Curve::Style::line;
    line.y_error.clear();
    line.in_key = line.in_table = false;
    panel.curves.push_back(line);
    for (const Eigen::Index observable : {0, 1}) {
        Curve points{.label = observable == 0 ? "shear stress" : "solid fraction",
                     .colour = observable == 0 ? model_colour : calibrated_colour,
                     .symbol = observable == 0 ? Symbol{} : Symbol{Shape::square, Filling::hollow}};
        points.y = residuals_of(comparison, observable);
        for (std::size_t k = 0; k < n; ++k) {
            points.x.push_back(normal_quantile(k, n));
        }
        panel.curves.push_back(points);
    }
    panel.key = Key::top_left;
    panel.headroom = 0.22;
    figure.panels = {panel};
    return figure;
}

/// Row of the ledger: a part of the readings, its part of chi2 and its number of measured values.
struct LedgerRow {
    std::string name;
    double chi2 = 0;
    double values = 0;
};

/// Parts with the largest chi2 per measured value, at most `most`, the largest first.
std::vector<LedgerRow> largest(std::vector<LedgerRow> parts, std::size_t most) {
    std::ranges::stable_sort(parts, std::greater(),
                             [](const LedgerRow& part) { return part.chi2 / part.values; });
    parts.resize(std::min(parts.size(), most));
    return parts;
}

std::string name_of(const Condition& c) {
    return fmt::format("{} Pa, {}, {}", nominal_text(c.normal_stress),
                       inertial_text(c.inertial_number),
                       c.dry() ? "dry" : fmt::format("content {:.3g}", c.liquid_content));
}

/// Parts of chi2 from observables, from files and from conditions: three groups.
std::vector<std::vector<LedgerRow>> ledger_rows(const Comparison& comparison) {
    constexpr std::size_t most_files = 6, most_conditions = 10;
    const auto count = static_cast<double>(comparison.readings.size());
    std::vector<LedgerRow> files, conditions;
    for (const FileMisfit& file : comparison.by_file) {
        files.push_back({plain_text(std::filesystem::path(file.file).filename().string()),
                         file.chi2, 2.0 * static_cast<double>(file.readings)});
    }
    for (const ConditionMisfit& each : comparison.by_condition) {
        conditions.push_back(
            {name_of(each.condition), each.chi2, 2.0 * static_cast<double>(each.readings.size())});
    }
    std::vector<std::vector<LedgerRow>> groups = {
        {{"shear stress", comparison.by_observable[0], count},
         {"solid fraction", comparison.by_observable[1], count}}};
    if (files.size() > 1) groups.push_back(largest(files, most_files));
    if (conditions.size() > 1) groups.push_back(largest(conditions, most_conditions));
    return groups;
}

Figure ledger_figure(const Comparison& comparison) {
    Figure figure{.name = "chi2_ledger", .title = "", .panels = {}};
    if (comparison.readings.empty()) return figure;
    figure.title = fmt::format("Parts of χ^2 = {:.1f} of {} values", comparison.total.chi2,
                               2 * comparison.readings.size() + comparison.direct.size());
    Panel panel{.x_label = "χ^2 per measured value (dashed: expected for a correct model)",
                .y_label = ""};
    Curve bars{.label = "part of the readings",
               .style = Curve::Style::bars_across,
               .colour = model_colour};
    const auto groups = ledger_rows(comparison);
    // Rows count upwards; an empty row divides the groups.
    for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
        if (group != groups.rbegin()) panel.y_names.emplace_back();
        for (auto part = group->rbegin(); part != group->rend(); ++part) {
            panel.y_names.push_back(part->name);
            bars.x.push_back(part->chi2 / part->values);
            bars.y.push_back(static_cast<double>(panel.y_names.size()));
        }
    }
    const double greatest = std::ranges::max(bars.x);
    panel.curves = {bars};
    panel.references = {{"expected for a correct model", 1, 0, true, calibrated_colour}};
    panel.x_range = {0, 1.08 * std::max(1.5, greatest)};
    panel.key = Key::none;  // the line would cross it
    figure.panels = {panel};
    return figure;
}

}  // namespace

std::vector<Figure> misfit_figures(const Comparison& comparison) {
    std::vector<Figure> figures = {quantile_figure(comparison), ledger_figure(comparison)};
    std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
    return figures;
}

}  // namespace pendular
