#include "reports/recording_course.h"

#include <algorithm>
#include <cmath>

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

}  // namespace pendular
