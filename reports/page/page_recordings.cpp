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

/// Row of each point minus the row of the point before it (0 before the first).
std::vector<std::uint32_t> steps_of(const PageRecording::Course& course) {
    std::vector<std::uint32_t> steps;
    std::size_t last = 0;
    for (const auto& [row, value] : course.points) {
        steps.push_back(static_cast<std::uint32_t>(row - last));
        last = row;
    }
    return steps;
}

/// Bytes that hold each of these numbers: 1, 2 or 4.
int width_of(const std::vector<std::uint32_t>& numbers) {
    const std::uint32_t greatest = std::ranges::max(numbers);
    if (greatest < 256) return 1;
    return greatest < 65'536 ? 2 : 4;
}

RecordingJson course_json(const PageRecording::Course& course) {
    const auto by_value = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [least, greatest] = std::ranges::minmax_element(course.points, by_value);
    const double low = least->second, range = greatest->second - low;
    const auto steps = steps_of(course);
    const int width = width_of(steps);
    constexpr double parts = 65'535;  // 2^16 - 1: two bytes a value
    Bytes bytes;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const double share = range > 0 ? (course.points[k].second - low) / range : 0;
        bytes.add_unsigned(steps[k], width);
        bytes.add_unsigned(static_cast<std::uint32_t>(std::lround(parts * share)), 2);
    }
    return {{"label", course.label},
            {"low", low},
            {"range", range},
            {"width", width},
            {"points", bytes.base64()}};
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

RecordingJson windows_json(const PageRecording& recording, const std::vector<Reading>& readings) {
    RecordingJson windows = RecordingJson::array();
    for (std::size_t k = 0; k < recording.windows.size(); ++k) {
        const AveragedWindow& window = recording.windows[k];
        RecordingJson means = RecordingJson::array();
        for (const PageRecording::Course& course : recording.courses) {
            means.push_back(course.means[k] ? rounded(*course.means[k]) : RecordingJson(nullptr));
        }
        windows.push_back({{"from", window.begin + 1},
                           {"to", window.end},
                           {"kind", text_of(window.kind)},
                           {"reading", reading_of(window, recording.file, readings)},
                           {"means", means}});
    }
    return windows;
}

}  // namespace

PageRecording page_recording(const FileView& view, const std::vector<Reading>& readings,
                             const std::vector<Remark>& left_out, std::size_t most) {
    PageRecording recording{.file = view.file.file,
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
    // A point has 3 to 6 bytes, 4 to 8 characters of base64: all points take at most 96 kB, unless
    // there are more than 300 recordings.
    constexpr std::size_t of_one = 400, of_all = 12'000, courses = 2;
    return std::clamp<std::size_t>(of_all / (courses * std::max<std::size_t>(1, recordings)), 20,
                                   of_one);
}

nlohmann::ordered_json recordings_json(const std::vector<PageRecording>& recordings,
                                       const std::vector<Reading>& readings) {
    RecordingJson result = RecordingJson::array();
    for (const PageRecording& recording : recordings) {
        RecordingJson parts = RecordingJson::array();
        for (const PageRecording::Course& course : recording.courses) {
            parts.push_back(course_json(course));
        }
        result.push_back({{"name", std::filesystem::path(recording.file).filename().string()},
                          {"parts", parts},
                          {"windows", windows_json(recording, readings)}});
    }
    return result;
}

}  // namespace pendular
