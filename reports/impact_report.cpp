#include "reports/impact_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "reports/figure.h"
#include "reports/figure_style.h"
#include "reports/with_error.h"

namespace pendular {
namespace {

/// Smallest shift worth a row of the table, in standard errors of the parameter [1].
constexpr double worth_a_row = 0.05;

std::string percent_text(double share) {
    return fmt::format("{:.2g} %", 100 * share);
}

/// Text of a size with its unit: "0.05", "0.41 mN m", "1 %".
std::string size_text(const Impact& impact, double size) {
    constexpr double rounding = 1e-15;  // of a fit that ends at a bound of 0
    if (std::abs(size) < rounding) size = 0;
    // Two digits would hide the difference between a factor and 1.
    if (impact.neutral != 0 && impact.unit == "1") return fmt::format("{:.4g}", size);
    if (!impact.measurement) return with_unit(size, impact.unit);
    return impact.quantity.empty() ? fmt::format("{:.2g} standard errors", size)
                                   : percent_text(size);
}

/// Text of a shift of a parameter with this standard error, with its sign.
std::string shift_text(double by, double error) {
    return change_text(by, by, error, "1");
}

/// Text of the size of a shift, without sign.
std::string size_of_shift(double by, double error) {
    return fmt::format("{:.{}f}", std::abs(by), decimals_for(error));
}

std::string group_name(const GroupImpact& sum) {
    return "sum, " + sum.group;
}

/// Number of characters of the longest name in the table.
std::size_t width_of(const ImpactTable& table) {
    std::size_t width = 24;
    for (const Impact& impact : table.impacts) {
        width = std::max(width, impact_name(impact).size());
    }
    for (const GroupImpact& sum : table.groups) {
        width = std::max(width, group_name(sum).size());
    }
    return width;
}

std::string row_of(const ImpactTable& table, const Impact& impact, std::size_t width) {
    const double error = table.errors(0);
    const auto both = [&](const Shift& shift) {
        const std::string size = impact.quantity == "on" ? "on" : size_text(impact, shift.size);
        const bool refitted = shift.refitted.size() > 0;
        return fmt::format("{:>14} {:>9}{}", size, shift_text(shift.best()(0), error),
                           refitted ? " " : "*");
    };
    return fmt::format("  {:<{}} {} {} {:>9} {:>7}", impact_name(impact), width,
                       both(impact.at_interest), both(impact.at_estimate),
                       size_of_shift(impact.by_error()(0), error),
                       std::isfinite(impact.pull()) ? fmt::format("{:.1f}", impact.pull()) : "-");
}

}  // namespace

std::string impact_name(const Impact& impact) {
    return impact.measurement && !impact.quantity.empty()
               ? fmt::format("{}, {}", impact.quantity, impact.name)
               : impact.name;
}

std::vector<std::string> by_impact(const ImpactTable& table,
                                   const std::vector<std::string>& effects) {
    std::vector<std::string> sorted = effects;
    std::ranges::stable_sort(sorted, {}, [&](const std::string& effect) {
        return std::ranges::find(table.impacts, effect, &Impact::name);
    });
    return sorted;
}

std::vector<std::string> impact_table(const ImpactTable& table) {
    if (table.impacts.empty()) return {};
    const std::string& parameter = table.parameters.front().name;
    const std::size_t width = width_of(table);
    std::vector<std::string> lines = {fmt::format(
        "  {:<{}} {:>14} {:>10} {:>14} {:>10} {:>9} {:>7}", "shift of " + parameter + " by", width,
        "matters from", "shift", "estimate", "shift", "per error", "errors")};
    std::size_t negligible = 0;
    for (const Impact& impact : table.impacts) {
        const std::array shifts = {impact.at_interest.best()(0), impact.at_estimate.best()(0),
                                   impact.by_error()(0)};
        const bool counts = std::ranges::any_of(
            shifts, [&](double shift) { return std::abs(shift) >= worth_a_row * table.errors(0); });
        if (counts)
            lines.push_back(row_of(table, impact, width));
        else
            ++negligible;
    }
    if (negligible > 0) {
        lines.push_back(fmt::format("  ... {} more that shift it by less than {} of its error",
                                    negligible, worth_a_row));
    }
    for (const GroupImpact& sum : table.groups) {
        const auto text = [&](const Eigen::VectorXd& by) {
            return size_of_shift(by(0), table.errors(0));
        };
        lines.push_back(fmt::format("  {:<{}} {:>14} {:>9}  {:>14} {:>9}  {:>9}", group_name(sum),
                                    width, "", text(sum.at_interest), "", text(sum.at_estimate),
                                    text(sum.by_error)));
    }
    lines.push_back(fmt::format(
        "  (shift of the fitted {} with the effect or the error of measurement in the model; "
        "matters from: the size that matters; *: linear, without a refit; per error: for one "
        "standard error of the estimate; errors: distance of the estimate from no effect, in "
        "standard errors; sum: root of the sum of squares)",
        parameter));
    return lines;
}

namespace {

constexpr std::size_t most_rows = 16;  ///< of the figure, which has one page

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
    Curve up{.label = "estimate of the effect plus its standard error",
             .style = Curve::Style::bars_across,
             .colour = model_colour},
        down{.label = "estimate of the effect minus its standard error",
             .style = Curve::Style::bars_across,
             .colour = "#f0a050"},  // lighter than the other bars in grey too
        interest{.label = "effect of the size that matters",
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
    // Shifts far beyond the bars, of effects of the size that matters, would shrink them:
    // left out.
    for (std::size_t k = interest.x.size(); k-- > 0;) {
        if (std::abs(interest.x[k]) > 1.05 * reach) {
            interest.x.erase(interest.x.begin() + static_cast<std::ptrdiff_t>(k));
            interest.y.erase(interest.y.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
    panel.curves = {up, down, interest};
    panel.references = {
        {"fitted " + plain_text(parameter) + ", ± 1 standard error", 0, error, true, "#888888"}};
    panel.x_range = {-1.08 * reach, 1.08 * reach};
    panel.key = true;
    return panel;
}

Panel pull_panel(const std::vector<const Impact*>& rows) {
    Panel panel{.x_label = "distance from no effect/standard error", .y_label = ""};
    Curve pulls{.label = "estimate of the effect", .colour = measured_colour};
    double reach = 3;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        pulls.x.push_back(rows[k]->pull());
        pulls.y.push_back(static_cast<double>(k) + 1);
        reach = std::max(reach, std::abs(rows[k]->pull()));
        panel.y_names.emplace_back();
    }
    panel.curves = {pulls};
    panel.references = {{"no effect, ± 1 standard error", 0, 1, true, "#888888"}};
    panel.x_range = {-1.08 * reach, 1.08 * reach};
    panel.key = true;
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
