#include "reports/recording_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>

#include "reports/figure.h"
#include "reports/figure_style.h"
#include "reports/layout.h"
#include "reports/locus_figures.h"

namespace pendular {
namespace {

using Kind = AveragedWindow::Kind;

Kind reached(bool plateau) {
    return plateau ? Kind::used : Kind::no_plateau;
}

std::vector<AveragedWindow> windows_of_preshears(const FileView& view) {
    std::vector<AveragedWindow> windows;
    std::size_t first = 0;
    for (std::size_t i = 0; i < view.series.size(); ++i) {
        const IntervalSeries& series = view.series[i];
        const bool stresses = !series.shear_stress.empty() && !series.normal_stress.empty();
        if (stresses && view.roles[i].role == "preshear") {
            const PreshearPoint point = preshear_point(series);
            windows.push_back({first + point.begin, first + series.size(), reached(point.plateau)});
        }
        first += series.size();
    }
    return windows;
}

/// Window of a point of failure: the rows of its smoothed peak; empty if it is not in `series`.
std::optional<AveragedWindow> window_of(const FailurePoint& point, const IntervalSeries& series,
                                        std::size_t first) {
    const bool own = !series.line.empty() && series.line.front() <= point.line &&
                     point.line <= series.line.back();
    if (!own || point.smoothed_end == 0) return std::nullopt;
    return AveragedWindow{first + point.smoothed_begin, first + point.smoothed_end,
                          reached(!point.at_end)};
}

std::vector<AveragedWindow> windows_of_roles(const FileView& view) {
    std::vector<AveragedWindow> windows = windows_of_preshears(view);
    for (const YieldLocus& locus : view.loci)
        for (const FailurePoint& point : locus.points) {
            std::size_t first = 0;
            for (const IntervalSeries& series : view.series) {
                if (const auto window = window_of(point, series, first)) windows.push_back(*window);
                first += series.size();
            }
        }
    return windows;
}

std::vector<AveragedWindow> windows_of_study(const FileView& view,
                                             const std::vector<Reading>& readings,
                                             const std::vector<Remark>& left_out) {
    std::vector<int> lines;
    for (const IntervalSeries& series : view.series)
        lines.insert(lines.end(), series.line.begin(), series.line.end());
    const auto row_of = [&](int line) {
        return static_cast<std::size_t>(std::ranges::lower_bound(lines, line) - lines.begin());
    };
    std::vector<AveragedWindow> windows;
    for (const Reading& reading : readings)
        if (reading.origin.file == view.file.file && reading.last_line >= reading.origin.line)
            windows.push_back({row_of(reading.origin.line), row_of(reading.last_line + 1),
                               Kind::used, reading.origin.line});
    for (const Remark& rows : left_out)
        if (rows.file() == view.file.file && (on_reading(rows.kind) || without_plateau(rows.kind)))
            windows.push_back({row_of(rows.first_line()), row_of(rows.last_line() + 1),
                               on_reading(rows.kind) ? Kind::set_aside : Kind::no_plateau});
    return windows;
}

}  // namespace

const char* text_of(AveragedWindow::Kind kind) {
    switch (kind) {
        case Kind::used:
            return "averaged";
        case Kind::no_plateau:
            return "averaged, no plateau";
        default:
            return "averaged, but set aside";
    }
}

std::vector<AveragedWindow> windows_of(const FileView& view, const std::vector<Reading>& readings,
                                       const std::vector<Remark>& left_out) {
    return readings.empty() && left_out.empty() ? windows_of_roles(view)
                                                : windows_of_study(view, readings, left_out);
}

RecordingCourse::RecordingCourse(const FileView& view, bool shear) : shear_(shear) {
    for (const IntervalSeries& series : view.series) {
        const std::vector<double>& column = shear ? series.shear() : series.normal();
        is_stress_ = is_stress_ || !(shear ? series.shear_stress : series.normal_stress).empty();
        for (std::size_t i = 0; i < series.size(); ++i) {
            const double value = i < column.size() ? column[i] : std::nan("");
            values_.push_back(shear ? std::abs(value) : value);
        }
    }
}

std::string RecordingCourse::label() const {
    if (shear_) return is_stress_ ? "shear stress [Pa]" : "torque [N m]";
    return is_stress_ ? "normal stress [Pa]" : "normal force [N]";
}

std::vector<std::pair<std::size_t, double>> RecordingCourse::points(std::size_t most) const {
    std::vector<std::pair<std::size_t, double>> known;
    for (std::size_t i = 0; i < values_.size(); ++i)
        if (std::isfinite(values_[i])) known.emplace_back(i + 1, values_[i]);
    if (known.size() <= most) return known;
    std::vector<std::pair<std::size_t, double>> thinned;
    const std::size_t bins = std::max<std::size_t>(1, most / 2);
    const auto by_value = [](const auto& a, const auto& b) { return a.second < b.second; };
    for (std::size_t k = 0; k < bins; ++k) {
        const auto at = [&](std::size_t bin) {
            return known.begin() + static_cast<std::ptrdiff_t>(bin * known.size() / bins);
        };
        const auto [least, greatest] = std::minmax_element(at(k), at(k + 1), by_value);
        thinned.push_back(*std::min(least, greatest));
        if (least != greatest) thinned.push_back(*std::max(least, greatest));
    }
    return thinned;
}

std::optional<double> RecordingCourse::mean(const AveragedWindow& window) const {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = window.begin; i < std::min(window.end, values_.size()); ++i)
        if (std::isfinite(values_[i])) sum += values_[i], ++count;
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

namespace {

const std::string reached_colour = "#2f8f4e", missed_colour = "#c8502d", circle_colour = "#5b9bd5",
                  aside_colour = "#8a8a8a";

std::string name_of(const FileView& view) {
    return std::filesystem::path(view.file.file).stem().string();
}

/// Name of a figure: letters, digits and underscores of a text.
std::string figure_name(const std::string& prefix, const std::string& text) {
    std::string name = prefix;
    for (const char c : text)
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

void add(Curve& curve, std::size_t row, double value) {
    curve.x.push_back(static_cast<double>(row));
    curve.y.push_back(value);
}

Curve recorded_curve(const RecordingCourse& course) {
    constexpr std::size_t most_points = 20'000;  // several for each dot of the figure
    Curve curve{.label = "recorded", .style = Curve::Style::line, .colour = measured_colour};
    for (const auto& [row, value] : course.points(most_points))
        add(curve, row, value);
    curve.weight = 0.5;
    return curve;
}

const std::string& colour_of(AveragedWindow::Kind kind) {
    switch (kind) {
        case AveragedWindow::Kind::used:
            return reached_colour;
        case AveragedWindow::Kind::no_plateau:
            return missed_colour;
        default:
            return aside_colour;
    }
}

Filling filling_of(AveragedWindow::Kind kind) {
    switch (kind) {
        case AveragedWindow::Kind::used:
            return Filling::filled;
        case AveragedWindow::Kind::no_plateau:
            return Filling::hollow;
        default:
            return Filling::crossed;
    }
}

/// The mean over a window, as a line from its begin to its end, or as points where a line would be
/// too short to be seen.
Curve mean_curve(const RecordingCourse& course, const AveragedWindow& window, bool first) {
    const bool is_short = 30 * (window.end - window.begin) < course.size(),
               used = window.kind == AveragedWindow::Kind::used;
    Curve curve{.label = text_of(window.kind),
                .style = is_short ? Curve::Style::points : Curve::Style::line,
                .colour = colour_of(window.kind),
                .symbol = {Shape::square, filling_of(window.kind)},
                .dash = used ? "solid" : "(3,2)",
                .weight = used ? 3.0 : 2.0,
                .area = 0.4,
                .in_key = first};
    if (const auto mean = course.mean(window))
        for (const std::size_t row : {window.begin + 1, window.end})
            add(curve, row, *mean);
    return curve;
}

Panel course_panel(const FileView& view, const std::vector<AveragedWindow>& windows, bool shear) {
    const RecordingCourse course(view, shear);
    Panel panel{.x_label = "row of the recording",
                .y_label = course.label(),
                .curves = {recorded_curve(course)}};
    std::set<AveragedWindow::Kind> in_key;
    for (const AveragedWindow& window : windows) {
        panel.curves.push_back(mean_curve(course, window, in_key.insert(window.kind).second));
    }
    std::erase_if(panel.curves, [](const Curve& curve) { return curve.x.empty(); });
    panel.key = true;
    return panel;
}

/// Upper half of a Mohr circle [Pa].
Curve half_circle(const std::string& label, double centre, double radius) {
    Curve curve{.label = label, .style = Curve::Style::line, .colour = circle_colour};
    constexpr int parts = 90;  // of 2 degrees
    for (int k = 0; k <= parts; ++k) {
        const double angle = std::numbers::pi * k / parts;
        curve.x.push_back(centre - radius * std::cos(angle));
        curve.y.push_back(radius * std::sin(angle));
    }
    return curve;
}

/// Largest normal stress [Pa] that the figure of a yield locus shows.
double greatest_stress(const YieldLocus& locus) {
    double greatest = 0;
    for (const FailurePoint& point : locus.points)
        greatest = std::max({greatest, point.normal_stress, point.shear_stress});
    if (locus.preshear) greatest = std::max(greatest, locus.preshear->normal_stress);
    return std::max({greatest, locus.line->major_principal_stress.value_or(0),
                     locus.line->unconfined_strength});
}

/// Marks strength and major principal stress where their Mohr circles meet the axis.
void add_marked_stresses(const LinearYieldLocus& line, Panel& panel) {
    const auto mark = [&](double stress, const std::string& label, Filling filling) {
        panel.curves.push_back(
            {.label = label, .colour = circle_colour, .symbol = {Shape::diamond, filling}});
        panel.curves.back().x = {stress};
        panel.curves.back().y = {0};
    };
    if (line.unconfined_strength > 0)
        mark(line.unconfined_strength, "unconfined strength", Filling::hollow);
    if (line.major_principal_stress)
        mark(*line.major_principal_stress, "major principal stress", Filling::filled);
}

Panel locus_panel(const YieldLocus& locus) {
    const LinearYieldLocus& line = *locus.line;
    Curve failures{.label = "points of failure", .colour = measured_colour};
    Curve at_end{.label = "failure perhaps not reached",
                 .colour = missed_colour,
                 .symbol = {Shape::circle, Filling::hollow}};
    for (const FailurePoint& point : locus.points) {
        Curve& curve = point.at_end ? at_end : failures;
        curve.x.push_back(point.normal_stress);
        curve.y.push_back(point.shear_stress);
    }
    const double greatest = greatest_stress(locus);
    const auto on_line = [&](double stress) {
        return line.intercept + std::tan(line.slope_angle) * stress;
    };
    Curve fitted{.label = "yield locus", .style = Curve::Style::line, .colour = calibrated_colour};
    // A line with a negative intercept begins on the axis of normal stress.
    const double begin = line.intercept < 0 ? -line.intercept / std::tan(line.slope_angle) : 0;
    fitted.x = {begin, greatest};
    fitted.y = {on_line(begin), on_line(greatest)};
    Panel panel{
        .x_label = "normal stress [Pa]", .y_label = "shear stress [Pa]", .curves = {fitted}};
    if (line.unconfined_strength > 0)
        panel.curves.push_back(half_circle("Mohr circle of strength", line.unconfined_strength / 2,
                                           line.unconfined_strength / 2));
    if (line.preshear_centre) {
        panel.curves.push_back(half_circle("Mohr circle of preshear", *line.preshear_centre,
                                           *line.major_principal_stress - *line.preshear_centre));
        panel.curves.back().style = Curve::Style::dashed_line;
    }
    add_marked_stresses(line, panel);
    if (locus.preshear && std::isfinite(locus.preshear->shear_stress)) {
        panel.curves.push_back({.label = "preshear",
                                .colour = reached_colour,
                                .symbol = {Shape::square, Filling::filled}});
        panel.curves.back().x = {locus.preshear->normal_stress};
        panel.curves.back().y = {locus.preshear->shear_stress};
    }
    for (Curve* const curve : {&failures, &at_end})
        if (!curve->x.empty()) panel.curves.push_back(*curve);
    panel.key = true;
    return panel;
}

/// Sets ranges with which one pascal is as long on both axes.
void set_equal_scales(Figure& figure, double greatest) {
    Panel& panel = figure.panels.front();
    panel.x_range = {{0, 1.05 * greatest}};
    const PanelPlace place = page_of(figure).panels.front();
    const double aspect = (place.top - place.bottom) / (place.right - place.left);
    panel.y_range = {{0, aspect * panel.x_range->second}};
}

/// @param named whether the test is named, as one of several
std::string locus_title(const YieldLocus& locus, bool named) {
    const LinearYieldLocus& line = *locus.line;
    std::string title = named && !locus.test.empty() ? plain_text(locus.test) + ": c" : "C";
    title += fmt::format(
        "ohesion {:.4g}\u00a0Pa, slope {:.3g}°, unconfined strength {:.4g}\u00a0Pa", line.cohesion,
        line.slope_angle * 180 / std::numbers::pi, line.unconfined_strength);
    if (line.flowability)
        title += fmt::format(": flowability {:.3g}, {}", *line.flowability, line.flow_class);
    return title;
}

}  // namespace

Figure recording_figure(const FileView& view, const std::vector<Reading>& readings,
                        const std::vector<Remark>& left_out) {
    const std::vector<AveragedWindow> windows = windows_of(view, readings, left_out);
    Figure figure{.name = figure_name("recording_", name_of(view)),
                  .title = plain_text("Recording " + name_of(view)),
                  .panels = {course_panel(view, windows, true), course_panel(view, windows, false)},
                  .stacked = true};
    std::erase_if(figure.panels, [](const Panel& panel) { return panel.curves.empty(); });
    return figure;
}

std::vector<Figure> yield_locus_figures(const FileView& view) {
    std::vector<Figure> figures;
    for (const YieldLocus& locus : view.loci) {
        if (!locus.line) continue;
        Figure figure{.name = fmt::format("yield_locus_{}", figures.size() + 1),
                      .title = locus_title(locus, view.loci.size() > 1),
                      .panels = {locus_panel(locus)}};
        set_equal_scales(figure, greatest_stress(locus));
        figures.push_back(std::move(figure));
    }
    return figures;
}

std::string unused_name(const std::string& name, const std::vector<Figure>& figures) {
    std::string unused = name;
    for (int k = 2; std::ranges::find(figures, unused, &Figure::name) != figures.end(); ++k)
        unused = fmt::format("{}_{}", name, k);
    return unused;
}

std::vector<Figure> file_figures(const FileView& view) {
    std::vector<Figure> figures = {recording_figure(view)};
    const bool results = std::ranges::all_of(  // a report, without the course of any interval
        view.series, [](const IntervalSeries& series) { return series.size() < 2; });
    if (results || figures.front().panels.empty()) figures.clear();
    std::ranges::move(yield_locus_figures(view), std::back_inserter(figures));
    std::ranges::move(wall_locus_figures(view), std::back_inserter(figures));
    return figures;
}

}  // namespace pendular
