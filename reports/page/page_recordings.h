#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/recording_course.h"

namespace pendular {

/// Recording in a study's HTML report: stresses against the number of the row, thinned to a few
/// hundred points, with the ranges of rows that are averaged.
struct PageRecording {
    /// Shear stress [Pa] or normal stress [Pa] against the number of the row, from 1. If the file
    /// has no stresses, torque [N m] or normal force [N] takes the place of the stress.
    struct Course {
        /// Axis label: name and unit of the quantity that is plotted against the number of the row.
        std::string label;
        std::vector<std::pair<std::size_t, double>> points;
        /// Mean of the recorded quantity over each averaging window in `windows`, in the unit of
        /// the quantity. Empty for a window without a recorded value.
        std::vector<std::optional<double>> means;
    };
    /// Path of the recording's file, equal to `origin.file` of the readings from this file.
    std::string file;
    /// Curves of the recording against the number of the row: shear stress, then normal stress. A
    /// stress without any recorded value is left out.
    std::vector<Course> courses;
    /// Ranges of rows of the recording that are averaged.
    std::vector<AveragedWindow> windows;
};

/// Returns the part of a recording that a study's HTML report shows: stresses against the number of
/// the row, and the ranges of rows that are averaged.
/// @param readings readings of the study; readings from files other than `view` are ignored
/// @param excluded rows that the study left out, with reasons
/// @param most maximum number of points for each stress
PageRecording page_recording(const FileView& view, const std::vector<Reading>& readings,
                             const std::vector<Excluded>& excluded, std::size_t most);

/// Returns the maximum number of points that a study's HTML report contains for each stress of a
/// recording: 400, or fewer (at least 20) if many recordings would make the report large.
/// @param recordings number of recordings in the report
std::size_t points_of_recordings(std::size_t recordings);

/// Returns the JSON of recordings for a study's HTML report. Each recording has the name of its
/// file, `parts` and `windows`:
/// - A part is a stress against the number of the row. It has a label, the keys `low`, `range` and
///   `width`, and the points as base64. Each point consists of two unsigned little-endian numbers:
///   first the number of rows since the previous point (`width` bytes), second a 16-bit number k.
///   The value at the point is low + range k/65535.
/// - A window is a range of rows that are averaged. It has its first and last row (counted from 1),
///   its kind as text, the index of the reading that averages the rows (null: no reading), and the
///   mean of each part.
/// @param readings all readings (measured shear stress and solid fraction) that the report shows
nlohmann::ordered_json recordings_json(const std::vector<PageRecording>& recordings,
                                       const std::vector<Reading>& readings);

}  // namespace pendular
