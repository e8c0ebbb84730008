#include "reports/misfit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "reports/figure.h"
#include "reports/figure_style.h"

namespace pendular {
namespace {

/// The last steps, whose names along x fit beside one another over the width of a page.
constexpr std::size_t most_ladder_steps = 8;

/// Lines with the day of a step and, where others have the same day, its time of day; none where
/// the time is unknown. They begin with a blank because tables join the lines of a name.
std::vector<std::string> lines_of_time(const LadderStep& step, const Ladder& ladder) {
    constexpr std::size_t day = std::string_view("2026-03-01").size();
    if (step.when.size() <= day) return {};
    const auto same_day = [&](const LadderStep& other) {
        return other.when.substr(0, day) == step.when.substr(0, day);
    };
    std::vector<std::string> lines = {" " + plain_text(step.when.substr(0, day))};
    if (std::ranges::count_if(ladder, same_day) > 1)
        lines.push_back(" " + plain_text(step.when.substr(day + 1)));
    return lines;
}

std::vector<std::string> name_of(const LadderStep& step) {
    if (step.change == "start") return {"start"};
    return broken_name((step.change == "add" ? "+ " : "− ") + step.effect);
}

/// Names of the steps, with the time below each, on the same line for all.
std::vector<std::vector<std::string>> names_of(const Ladder& ladder) {
    std::vector<std::vector<std::string>> names;
    std::size_t most = 0;
    for (const LadderStep& step : ladder) {
        names.push_back(name_of(step));
        if (!step.when.empty()) most = std::max(most, names.back().size());
    }
    for (std::size_t k = 0; k < ladder.size(); ++k) {
        const std::vector<std::string> time = lines_of_time(ladder[k], ladder);
        if (time.empty()) continue;
        names[k].resize(most);
        names[k].insert(names[k].end(), time.begin(), time.end());
    }
    return names;
}

/// Vertical lines between two steps of a ladder where the ladder starts anew.
std::vector<Reference> new_starts(const Ladder& ladder) {
    std::vector<Reference> lines;
    for (std::size_t k = 1; k < ladder.size(); ++k) {
        if (ladder[k].change == "start") {
            lines.push_back({"", static_cast<double>(k) + 0.5, 0, true, "#b0b0b0"});
        }
    }
    return lines;
}

/// Text of a positive number with about two significant digits, without an exponent.
std::string short_number(double value) {
    return fmt::format("{:.{}f}", value, value < 0.995 ? 2 : value < 9.95 ? 1 : 0);
}

/// Staircase of values, level at each step and vertical between two, so that a text above a step is
/// clear of it; interrupted where the ladder starts anew.
Curve staircase(const Curve& points, const Ladder& ladder) {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    Curve line{.style = Curve::Style::line,
               .colour = points.colour,
               .weight = 0.8,
               .in_key = false,
               .in_table = false};
    for (std::size_t k = 0; k < points.x.size(); ++k) {
        const auto step = static_cast<std::size_t>(std::lround(points.x[k])) - 1;
        if (k > 0 && ladder[step].change == "start") {
            line.x.push_back(gap);
            line.y.push_back(gap);
        }
        for (const double side : {-0.5, 0.5}) {
            line.x.push_back(points.x[k] + side);
            line.y.push_back(points.y[k]);
        }
    }
    return line;
}

Panel chi2_panel(const Ladder& ladder) {
    Panel panel{.x_label = "", .y_label = "χ^2 per degree of freedom"};
    Curve points{.label = "model of the study", .colour = measured_colour};
    panel.x_names.resize(ladder.size());
    std::vector<double> values = {1};
    for (std::size_t k = 0; k < ladder.size(); ++k) {
        const double value = ladder[k].chi2_per_dof();
        if (!std::isfinite(value)) {
            continue;
        }
        points.x.push_back(static_cast<double>(k) + 1);
        points.y.push_back(value);
        points.names.push_back(short_number(value));
        values.push_back(value);
    }
    panel.references = new_starts(ladder);
    panel.references.push_back({"expected for a correct model", 1, 0, false, calibrated_colour});
    panel.curves = {staircase(points, ladder), points};
    panel.log_y = spans_decade(values);
    panel.y_from_zero = true;
    panel.key = true;
    return panel;
}

/// RMS errors of one observable along a ladder [%], for the readings or for conditions left out of
/// the fit. The two kinds are drawn to either side of the middle of their step.
Curve error_curve(const Ladder& ladder, std::size_t observable, bool left_out) {
    Curve curve{.label = fmt::format("{}, {}", observable == 0 ? "shear stress" : "solid fraction",
                                     left_out ? "readings left out" : "fitted readings"),
                .colour = observable == 0 ? model_colour : calibrated_colour,
                .symbol = {observable == 0 ? Shape::circle : Shape::square,
                           left_out ? Filling::hollow : Filling::filled}};
    for (std::size_t k = 0; k < ladder.size(); ++k) {
        const auto& errors = left_out ? ladder[k].left_out_percent : ladder[k].rms_percent;
        if (errors && std::isfinite((*errors)[observable])) {
            curve.x.push_back(static_cast<double>(k) + (left_out ? 1.12 : 0.88));
            curve.y.push_back((*errors)[observable]);
        }
    }
    return curve;
}

/// Lines through points, interrupted at `breaks`, where the ladder starts anew.
std::vector<Curve> lines_through(const Curve& points, const std::vector<Reference>& breaks) {
    std::vector<Curve> lines;
    std::ptrdiff_t last = -1;
    for (std::size_t k = 0; k < points.x.size(); ++k) {
        const std::ptrdiff_t part = std::ranges::count_if(
            breaks, [&](const Reference& line) { return line.value < points.x[k]; });
        if (part != last) {
            Curve line = points;
            line.style = Curve::Style::dotted_line;
            line.in_key = false;
            line.in_table = false;
            line.x.clear(), line.y.clear();
            lines.push_back(line);
            last = part;
        }
        lines.back().x.push_back(points.x[k]);
        lines.back().y.push_back(points.y[k]);
    }
    return lines;
}

Panel error_panel(const Ladder& ladder) {
    Panel panel{.x_label = "", .y_label = "RMS error [%]"};
    panel.references = new_starts(ladder);
    std::vector<double> values;
    std::vector<Curve> points;
    for (const std::size_t observable : {0u, 1u}) {
        for (const bool left_out : {false, true}) {
            const Curve curve = error_curve(ladder, observable, left_out);
            if (curve.x.empty()) {
                continue;
            }
            values.insert(values.end(), curve.y.begin(), curve.y.end());
            points.push_back(curve);
            for (const Curve& line : lines_through(curve, panel.references)) {
                panel.curves.push_back(line);
            }
        }
    }
    panel.curves.insert(panel.curves.end(), points.begin(), points.end());
    panel.x_names = names_of(ladder);
    panel.log_y = !values.empty() && spans_decade(values);
    panel.key = true;
    panel.y_from_zero = true;
    return panel;
}

}  // namespace

Figure ladder_figure(const Ladder& whole) {
    const auto hidden =
        static_cast<std::ptrdiff_t>(whole.size() - std::min(whole.size(), most_ladder_steps));
    const Ladder ladder(whole.begin() + hidden, whole.end());
    return {
        .name = "ladder",
        .title = hidden > 0
                     ? fmt::format("Error of the model, effect by effect: the last {} of {} steps",
                                   ladder.size(), whole.size())
                     : "Error of the model, effect by effect",
        .panels = {chi2_panel(ladder), error_panel(ladder)},
        .stacked = true};
}

}  // namespace pendular
