#include "reports/impact_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "reports/figure_style.h"
#include "reports/figure_text.h"
#include "reports/impact_report.h"

namespace pendular {
namespace {

constexpr std::size_t most_rows = 16;

/// Impacts of the figure, the smallest first: rows count upwards.
std::vector<const Impact*> rows_of(const ImpactTable& table) {
    std::vector<const Impact*> rows;
    for (const Impact& impact : table.impacts) {
        if (impact.error > 0 && impact.by_error().allFinite()) rows.push_back(&impact);
    }
    std::ranges::stable_sort(rows, std::greater<>(),
                             [](const Impact* impact) { return impact->by_error()(0); });
    rows.resize(std::min(rows.size(), most_rows));
    std::ranges::reverse(rows);
    return rows;
}

/// Factor on shifts in the figure: those of a friction are drawn in thousandths [1].
constexpr double in_thousandths = 1e3;

/// Reach of the axis: the longest bar, but not bars that are more than three times as long as all
/// others and would leave these unreadable; such bars end at the axis, with their length as text.
double reach_of(std::vector<double> lengths) {
    constexpr double far_longer = 3;
    std::ranges::sort(lengths);
    while (lengths.size() > 2 && lengths.back() > far_longer * lengths[lengths.size() - 2]) {
        lengths.pop_back();
        lengths.back() *= 1.15;  // so that a bar that is cut differs from one that ends
    }
    return lengths.back();
}

Panel shift_panel(const ImpactTable& table, const std::vector<const Impact*>& rows) {
    const std::string& parameter = table.parameters.front().name;
    Panel panel{.x_label = "10^3 × shift of " + plain_text(parameter), .y_label = ""};
    Curve up{.label = "estimate plus its standard error",
             .style = Curve::Style::bars_across,
             .colour = model_colour},
        down{.label = "estimate minus its standard error",
             .style = Curve::Style::bars_across,
             .colour = calibrated_colour},
        interest{.label = "effect of the smallest size of interest",
                 .colour = measured_colour,
                 .symbol = {Shape::diamond, Filling::hollow}};
    const double error = in_thousandths * table.errors(0);
    std::vector<double> reaches = {error};
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double row = static_cast<double>(k) + 1;
        for (const auto& [curve, shift] :
             {std::pair(&up, rows[k]->up()(0)), std::pair(&down, rows[k]->down()(0)),
              std::pair(&interest, rows[k]->at_interest.best()(0))}) {
            curve->x.push_back(in_thousandths * shift);
            curve->y.push_back(row);
            if (curve != &interest) {
                curve->names.push_back(fmt::format("{:.3g}", curve->x.back()));
            }
        }
        reaches.push_back(in_thousandths *
                          std::max(std::abs(rows[k]->up()(0)), std::abs(rows[k]->down()(0))));
        panel.y_names.push_back(plain_text(impact_name(*rows[k])));
    }
    const double reach = reach_of(reaches);
    // Shifts far beyond the bars, of effects of the smallest size of interest, would shrink them:
    // left out.
    for (std::size_t k = interest.x.size(); k-- > 0;) {
        if (std::abs(interest.x[k]) > 1.05 * reach) {
            interest.x.erase(interest.x.begin() + static_cast<std::ptrdiff_t>(k));
            interest.y.erase(interest.y.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
    panel.curves = {up, down, interest};
    panel.references = {
        {"standard error of the fitted " + plain_text(parameter), 0, error, true, "#888888"}};
    panel.x_range = {-1.08 * reach, 1.08 * reach};
    panel.key = Key::top_left;
    panel.headroom = 0.2;
    return panel;
}

Panel pull_panel(const std::vector<const Impact*>& rows) {
    Panel panel{.x_label = "pull: (estimate - value without effect) / standard error",
                .y_label = ""};
    Curve pulls{.label = "pull", .colour = measured_colour};
    double reach = 3;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        pulls.x.push_back(rows[k]->pull());
        pulls.y.push_back(static_cast<double>(k) + 1);
        reach = std::max(reach, std::abs(rows[k]->pull()));
        panel.y_names.emplace_back();
    }
    panel.curves = {pulls};
    panel.references = {{"no effect, within one standard error", 0, 1, true, "#888888"}};
    panel.x_range = {-1.08 * reach, 1.08 * reach};
    panel.key = Key::top_left;
    panel.headroom = 0.2;
    return panel;
}

}  // namespace

Figure impact_figure(const ImpactTable& table) {
    Figure figure{.name = "impact", .title = "", .panels = {}};
    const auto rows = rows_of(table);
    if (rows.empty()) return figure;
    figure.title = plain_text("Impact of effects and errors of measurement on the fitted " +
                              table.parameters.front().name);
    figure.panels = {shift_panel(table, rows), pull_panel(rows)};
    // At a bound of the friction nothing shifts it: the empty panel goes, and the other one takes
    // its names of the rows.
    if (!(figure.panels.front().x_range->second > 0)) {
        figure.panels.back().y_names = figure.panels.front().y_names;
        figure.panels.erase(figure.panels.begin());
    }
    return figure;
}

}  // namespace pendular
