#include "reports/locus_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "reports/figure_style.h"

namespace pendular {
namespace {

Curve line_from_axis(const std::string& label, double intercept, double slope, double to,
                     const std::string& colour) {
    Curve curve{.label = label, .style = Curve::Style::line, .colour = colour};
    curve.x = {0, to};
    curve.y = {intercept, intercept + slope * to};
    return curve;
}

}  // namespace

std::optional<Figure> flow_function_figure(const std::vector<FileView>& views) {
    Curve points{.label = "yield loci", .colour = measured_colour};
    double greatest = 0, strongest = 0;
    for (const FileView& view : views)
        for (const YieldLocus& locus : view.loci) {
            if (!locus.line || !locus.line->major_principal_stress) continue;
            const LinearYieldLocus& line = *locus.line;
            points.x.push_back(*line.major_principal_stress);
            points.y.push_back(line.unconfined_strength);
            points.y_error.push_back(line.errors ? line.errors->unconfined_strength : 0);
            greatest = std::max(greatest, points.x.back());
            strongest = std::max(strongest, points.y.back() + points.y_error.back());
        }
    if (points.x.size() < 2) return std::nullopt;
    Panel panel{.x_label = "major principal stress [Pa]",
                .y_label = "unconfined strength [Pa]",
                .key = true};
    panel.x_range = {{0, 1.05 * greatest}};
    constexpr double least_share = 0.15;  // so that the line of flowability 10 is seen
    panel.y_range = {{0, 1.15 * std::max(strongest, least_share * greatest)}};
    // Classes of flowability, the major principal stress over the strength.
    for (const auto& [limit, dash] : {std::pair(1, "solid"), std::pair(2, "(10,4)"),
                                      std::pair(4, "(3,3)"), std::pair(10, "(10,4,2,4)")}) {
        const double end = std::min(panel.x_range->second, limit * panel.y_range->second);
        panel.curves.push_back(
            line_from_axis(fmt::format("flowability {}", limit), 0, 1.0 / limit, end, "#8a8a8a"));
        panel.curves.back().dash = dash;
        panel.curves.back().in_table = false;
    }
    panel.curves.push_back(std::move(points));
    return Figure{.name = "flow_function", .title = "Flow function", .panels = {panel}};
}

std::vector<Figure> wall_locus_figures(const FileView& view) {
    std::vector<Figure> figures;
    for (const WallLocus& wall : view.walls) {
        Curve points{.label = "points", .colour = measured_colour};
        for (const WallPoint& point : wall.points) {
            points.x.push_back(point.normal_stress);
            points.y.push_back(point.shear_stress);
        }
        const double greatest = 1.05 * *std::ranges::max_element(points.x);
        const WallLine line = wall.line();
        Panel panel{.x_label = "normal stress [Pa]",
                    .y_label = "shear stress [Pa]",
                    .curves = {line_from_axis("wall yield locus", line.intercept, line.slope,
                                              greatest, calibrated_colour),
                               points},
                    .key = true};
        panel.x_range = {{0, greatest}};
        panel.y_from_zero = true;
        figures.push_back({.name = fmt::format("wall_locus_{}", figures.size() + 1),
                           .title = fmt::format("Wall yield locus: angle of wall friction {:.3g}°",
                                                std::atan(line.slope) * 180 / std::numbers::pi),
                           .panels = {panel}});
    }
    return figures;
}

}  // namespace pendular
