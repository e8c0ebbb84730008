#include "reports/page/page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace pendular {
namespace {

using RecordingJson = nlohmann::ordered_json;

/// Number with seven significant digits.
RecordingJson rounded(double value) {
    return std::stod(fmt::format("{:.7g}", value));
}

constexpr double most_of_two_bytes = 65'535;  ///< 2^16 - 1: two bytes a number

/// Along the x axis of a recording: time or, without it, number of the row.
struct TimeAxis {
    std::string label = "row of the recording";
    std::vector<double> of_row;  ///< empty: the number of the row, from 1
    double from = 1, span = 1;

    double at(std::size_t row) const {
        return of_row.empty() ? static_cast<double>(row) : of_row[row - 1];
    }
};

TimeAxis axis_of(const PageRecording& recording) {
    TimeAxis axis;
    std::size_t last = 1;
    for (const PageRecording::Course& course : recording.courses) {
        last = std::max(last, course.points.back().first);
    }
    if (!recording.time.empty()) {
        const double duration = recording.time.back() - recording.time.front();
        constexpr double minute = 60, longest_in_seconds = 600;  // chosen: three digits on the axis
        const bool minutes = duration > longest_in_seconds;
        axis.label = minutes ? "time [min]" : "time [s]";
        axis.of_row = recording.time;
        for (double& value : axis.of_row) {
            value /= minutes ? minute : 1;
        }
    }
    axis.from = axis.at(1);
    axis.span = axis.at(axis.of_row.empty() ? last : axis.of_row.size()) - axis.from;
    return axis;
}

void add_share(Bytes& bytes, double value, double low, double range) {
    const double share = range > 0 ? (value - low) / range : 0;
    bytes.add_unsigned(static_cast<std::uint32_t>(std::lround(most_of_two_bytes * share)), 2);
}

RecordingJson course_json(const PageRecording::Course& course, const TimeAxis& axis) {
    const auto by_value = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [least, greatest] = std::ranges::minmax_element(course.points, by_value);
    const double low = least->second, range = greatest->second - low;
    Bytes bytes;
    for (const auto& [row, value] : course.points) {
        add_share(bytes, axis.at(row), axis.from, axis.span);
        add_share(bytes, value, low, range);
    }
    return {{"label", course.label}, {"low", low}, {"range", range}, {"points", bytes.base64()}};
}

/// Index of the reading that averages a window of a file; null where none does.
RecordingJson reading_of(const AveragedWindow& window, const std::string& file,
                         const std::vector<Reading>& readings) {
    const auto found = std::ranges::find_if(readings, [&](const Reading& reading) {
        return window.line > 0 && reading.origin.file == file && reading.origin.line == window.line;
    });
    if (found == readings.end()) return nullptr;
    return found - readings.begin();
}

/// Outcome of an averaged range of rows.
const char* outcome(AveragedWindow::Kind kind) {
    switch (kind) {
        case AveragedWindow::Kind::used:
            return "reading";
        case AveragedWindow::Kind::no_plateau:
            return "no plateau, no reading";
        default:
            return "set aside";
    }
}

RecordingJson windows_json(const PageRecording& recording, const TimeAxis& axis,
                           const std::vector<Reading>& readings) {
    RecordingJson windows = RecordingJson::array();
    for (std::size_t k = 0; k < recording.windows.size(); ++k) {
        const AveragedWindow& window = recording.windows[k];
        RecordingJson means = RecordingJson::array();
        for (const PageRecording::Course& course : recording.courses) {
            means.push_back(course.means[k] ? rounded(*course.means[k]) : RecordingJson(nullptr));
        }
        windows.push_back({{"from", rounded(axis.at(window.begin + 1))},
                           {"to", rounded(axis.at(window.end))},
                           {"kind", outcome(window.kind)},
                           {"reading", reading_of(window, recording.file, readings)},
                           {"means", means}});
    }
    return windows;
}

/// Time of each row, intervals one after the other; empty where a row has none.
std::vector<double> times_of(const FileView& view) {
    std::vector<double> times;
    double before = 0;  // where an interval begins that counts from 0 again
    for (const IntervalSeries& series : view.series) {
        if (series.time.size() != series.size()) return {};
        const bool again =
            !times.empty() && !series.time.empty() && series.time.front() + before < times.back();
        if (again) before = times.back() - series.time.front();
        for (const double time : series.time) {
            times.push_back(time + before);
        }
    }
    const bool known = std::ranges::all_of(times, [](double t) { return std::isfinite(t); });
    return known && std::ranges::is_sorted(times) ? times : std::vector<double>{};
}

}  // namespace

PageRecording page_recording(const FileView& view, const std::vector<Reading>& readings,
                             const std::vector<Remark>& left_out, std::size_t most) {
    PageRecording recording{.file = view.file.file,
                            .time = times_of(view),
                            .courses = {},
                            .windows = windows_of(view, readings, left_out)};
    for (const bool shear : {true, false}) {
        const RecordingCourse course(view, shear);
        PageRecording::Course shown{.label = course.label(), .points = course.points(most)};
        for (const AveragedWindow& window : recording.windows) {
            shown.means.push_back(course.mean(window));
        }
        if (!shown.points.empty()) recording.courses.push_back(std::move(shown));
    }
    return recording;
}

std::size_t points_of_recordings(std::size_t recordings) {
    // A point has 4 bytes, 5.3 characters of base64: all points take at most 64 kB, unless
    // there are more than 300 recordings.
    constexpr std::size_t of_one = 400, of_all = 12'000, courses = 2;
    return std::clamp<std::size_t>(of_all / (courses * std::max<std::size_t>(1, recordings)), 20,
                                   of_one);
}

nlohmann::ordered_json recordings_json(const std::vector<PageRecording>& recordings,
                                       const std::vector<Reading>& readings) {
    RecordingJson result = RecordingJson::array();
    for (const PageRecording& recording : recordings) {
        const TimeAxis axis = axis_of(recording);
        RecordingJson panels = RecordingJson::array();
        for (const PageRecording::Course& course : recording.courses) {
            panels.push_back(course_json(course, axis));
        }
        result.push_back({{"name", std::filesystem::path(recording.file).filename().string()},
                          {"x_label", axis.label},
                          {"from", rounded(axis.from)},
                          {"span", rounded(axis.span)},
                          {"parts", panels},
                          {"windows", windows_json(recording, axis, readings)}});
    }
    return result;
}

}  // namespace pendular
